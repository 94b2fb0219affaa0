package io.github.glideslam.android;

import android.annotation.TargetApi;
import android.graphics.Rect;
import android.graphics.SurfaceTexture;
import android.hardware.camera2.CameraAccessException;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraCharacteristics.Key;
import android.hardware.camera2.CameraManager;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.params.StreamConfigurationMap;
import android.os.Build;
import android.util.Range;
import android.util.Size;
import android.util.SizeF;
import io.github.glideslam.UnsupportedConfigurationException;

/** CameraCharacteristics, read with care: keys may be missing. */
final class CameraReport {
  private final CameraCharacteristics told;

  CameraReport(CameraCharacteristics told) {
    this.told = told;
  }

  /** The camera on the device's back, if there are several the first one made for tracking. */
  static String backCamera(CameraManager manager) throws CameraAccessException {
    String first = null;
    for (String id : manager.getCameraIdList()) {
      CameraReport report = new CameraReport(manager.getCameraCharacteristics(id));
      int facing = report.get(CameraCharacteristics.LENS_FACING, CameraMetadata.LENS_FACING_FRONT);
      if (facing != CameraMetadata.LENS_FACING_BACK) {
        continue;
      }
      if (report.tracksMotion()) {
        return id;
      }
      first = first == null ? id : first;
    }
    if (first == null) {
      throw new UnsupportedConfigurationException("there is no camera on the device's back");
    }
    return first;
  }

  <T> T get(Key<T> key, T otherwise) {
    T value = told.get(key);
    return value != null ? value : otherwise;
  }

  boolean has(Key<int[]> key, int wanted) {
    for (int value : get(key, new int[0])) {
      if (value == wanted) {
        return true;
      }
    }
    return false;
  }

  /** Whether there is a capture intent for it. */
  boolean tracksMotion() {
    return Build.VERSION.SDK_INT >= Build.VERSION_CODES.P
        && has(CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES,
            CameraMetadata.REQUEST_AVAILABLE_CAPABILITIES_MOTION_TRACKING);
  }

  Size streamSize(Size wanted) {
    StreamConfigurationMap streams =
        told.get(CameraCharacteristics.SCALER_STREAM_CONFIGURATION_MAP);
    Size[] sizes = streams == null ? null : streams.getOutputSizes(SurfaceTexture.class);
    if (sizes == null || sizes.length == 0) {
      throw new UnsupportedConfigurationException("the camera offers no images");
    }
    return StreamChoice.size(sizes, wanted);
  }

  /** Null when the camera tells none. */
  Range<Integer> frameRate(int wanted) {
    Range<Integer>[] rates =
        told.get(CameraCharacteristics.CONTROL_AE_AVAILABLE_TARGET_FPS_RANGES);
    return rates == null ? null : StreamChoice.frameRate(rates, wanted);
  }

  /** The whole crop region, the correction of distortion off where it can be. */
  CameraFacts facts(Size stream) {
    CameraFacts facts = new CameraFacts();
    facts.activeArray = pixelRect(told.get(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE));
    facts.preCorrectionArray = pixelRect(get(
        CameraCharacteristics.SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE,
        told.get(CameraCharacteristics.SENSOR_INFO_ACTIVE_ARRAY_SIZE)));
    Size pixels = get(
        CameraCharacteristics.SENSOR_INFO_PIXEL_ARRAY_SIZE,
        new Size(facts.activeArray.width, facts.activeArray.height));
    facts.pixelArrayWidth = pixels.getWidth();
    facts.pixelArrayHeight = pixels.getHeight();
    SizeF sensor = get(CameraCharacteristics.SENSOR_INFO_PHYSICAL_SIZE, new SizeF(0, 0));
    facts.sensorWidthMm = sensor.getWidth();
    facts.sensorHeightMm = sensor.getHeight();
    float[] focal = get(CameraCharacteristics.LENS_INFO_AVAILABLE_FOCAL_LENGTHS, new float[1]);
    facts.focalLengthMm = focal.length > 0 ? focal[0] : 0;
    facts.intrinsicCalibration = told.get(CameraCharacteristics.LENS_INTRINSIC_CALIBRATION);
    facts.streamWidth = stream.getWidth();
    facts.streamHeight = stream.getHeight();
    if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.P) {
      addDistortion(facts);
    }
    return facts;
  }

  @TargetApi(28)
  private void addDistortion(CameraFacts facts) {
    facts.distortion = told.get(CameraCharacteristics.LENS_DISTORTION);
    int[] modes = told.get(CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES);
    if (modes != null) {
      facts.correction =
          canLeaveDistortion() ? CameraFacts.Correction.OFF : CameraFacts.Correction.ON;
    }
  }

  /** Whether what the lens does is known, and images without a correction can be had. */
  @TargetApi(28)
  boolean canLeaveDistortion() {
    return told.get(CameraCharacteristics.LENS_DISTORTION) != null
        && has(CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES,
            CameraMetadata.DISTORTION_CORRECTION_MODE_OFF);
  }

  private static PixelRect pixelRect(Rect rect) {
    if (rect == null) {
      throw new UnsupportedConfigurationException("the camera does not tell its sensor's size");
    }
    return new PixelRect(rect.left, rect.top, rect.width(), rect.height());
  }
}
