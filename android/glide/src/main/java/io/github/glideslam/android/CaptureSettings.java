package io.github.glideslam.android;

import android.annotation.TargetApi;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.os.Build;
import android.util.Range;

/** What is asked of the camera so that its images can be tracked: everything in the lens rests. */
final class CaptureSettings {
  private final CameraReport camera;
  private final Range<Integer> frameRate;

  CaptureSettings(CameraReport camera, int framesPerSecond) {
    this.camera = camera;
    frameRate = camera.frameRate(framesPerSecond);
  }

  void applyTo(CaptureRequest.Builder request) {
    request.set(
        CaptureRequest.CONTROL_VIDEO_STABILIZATION_MODE,
        CameraMetadata.CONTROL_VIDEO_STABILIZATION_MODE_OFF);
    if (camera.has(
        CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION,
        CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF)) {
      request.set(
          CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE,
          CameraMetadata.LENS_OPTICAL_STABILIZATION_MODE_OFF);
    }
    if (frameRate != null) {
      request.set(CaptureRequest.CONTROL_AE_TARGET_FPS_RANGE, frameRate);
    }
    lockFocus(request);
    if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.P) {
      applyNewer(request);
    }
  }

  /**
   * At the hyperfocal distance: sharp from half of it to infinity. Where the focus cannot be set, AUTO
   * without a trigger leaves it where it is.
   */
  private void lockFocus(CaptureRequest.Builder request) {
    if (!camera.has(
        CameraCharacteristics.CONTROL_AF_AVAILABLE_MODES, CameraMetadata.CONTROL_AF_MODE_OFF)) {
      request.set(CaptureRequest.CONTROL_AF_MODE, CameraMetadata.CONTROL_AF_MODE_AUTO);
      return;
    }
    request.set(CaptureRequest.CONTROL_AF_MODE, CameraMetadata.CONTROL_AF_MODE_OFF);
    if (camera.get(CameraCharacteristics.LENS_INFO_MINIMUM_FOCUS_DISTANCE, 0f) > 0) {
      // In dioptres; 0 is infinity.
      request.set(
          CaptureRequest.LENS_FOCUS_DISTANCE,
          camera.get(CameraCharacteristics.LENS_INFO_HYPERFOCAL_DISTANCE, 0f));
    }
  }

  @TargetApi(28)
  private void applyNewer(CaptureRequest.Builder request) {
    if (camera.tracksMotion()) {
      request.set(
          CaptureRequest.CONTROL_CAPTURE_INTENT,
          CameraMetadata.CONTROL_CAPTURE_INTENT_MOTION_TRACKING);
    }
    if (camera.canLeaveDistortion()) {
      request.set(
          CaptureRequest.DISTORTION_CORRECTION_MODE,
          CameraMetadata.DISTORTION_CORRECTION_MODE_OFF);
    }
  }
}
