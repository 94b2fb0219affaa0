package io.github.glideslam.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import android.graphics.Rect;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraMetadata;
import android.hardware.camera2.CaptureRequest;
import android.util.Range;
import android.util.Size;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;

@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34, manifest = Config.NONE)
public final class CaptureSettingsTest {
  private static final int WANTED_RATE = 30;

  private static CaptureRequest.Builder requestFor(PhoneCamera camera) {
    CaptureRequest.Builder request = Shadow.newInstanceOf(CaptureRequest.Builder.class);
    new CaptureSettings(new CameraReport(camera.characteristics()), WANTED_RATE).applyTo(request);
    return request;
  }

  @Test
  public void everythingInTheLensRests() {
    CaptureRequest.Builder request = requestFor(new PhoneCamera());
    assertEquals(0, (int) request.get(CaptureRequest.CONTROL_VIDEO_STABILIZATION_MODE));
    assertEquals(0, (int) request.get(CaptureRequest.LENS_OPTICAL_STABILIZATION_MODE));
    assertEquals(
        CameraMetadata.CONTROL_AF_MODE_OFF, (int) request.get(CaptureRequest.CONTROL_AF_MODE));
    assertEquals(0.25f, request.get(CaptureRequest.LENS_FOCUS_DISTANCE), 0);
    assertEquals(
        new Range<>(30, 30), request.get(CaptureRequest.CONTROL_AE_TARGET_FPS_RANGE));
  }

  @Test
  public void theIntentIsMotionTrackingWhereTheCameraCan() {
    PhoneCamera camera = new PhoneCamera().with(
        CameraCharacteristics.REQUEST_AVAILABLE_CAPABILITIES,
        new int[] {CameraMetadata.REQUEST_AVAILABLE_CAPABILITIES_MOTION_TRACKING});
    assertEquals(
        CameraMetadata.CONTROL_CAPTURE_INTENT_MOTION_TRACKING,
        (int) requestFor(camera).get(CaptureRequest.CONTROL_CAPTURE_INTENT));
    assertNull(requestFor(new PhoneCamera()).get(CaptureRequest.CONTROL_CAPTURE_INTENT));
  }

  @Test
  public void aKnownDistortionIsLeftInTheImages() {
    PhoneCamera camera = new PhoneCamera()
        .calibrated()
        .with(CameraCharacteristics.LENS_DISTORTION, new float[] {0.1f, 0, 0, 0, 0})
        .with(CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES, new int[] {0, 1});
    assertEquals(0, (int) requestFor(camera).get(CaptureRequest.DISTORTION_CORRECTION_MODE));
    CameraFacts facts = new CameraReport(camera.characteristics()).facts(new Size(640, 480));
    assertEquals(CameraFacts.Correction.OFF, facts.correction);
  }

  @Test
  public void anUnknownDistortionIsLeftToTheCamera() {
    PhoneCamera camera = new PhoneCamera().with(
        CameraCharacteristics.DISTORTION_CORRECTION_AVAILABLE_MODES, new int[] {0, 1});
    assertNull(requestFor(camera).get(CaptureRequest.DISTORTION_CORRECTION_MODE));
    CameraFacts facts = new CameraReport(camera.characteristics()).facts(new Size(640, 480));
    assertEquals(CameraFacts.Correction.ON, facts.correction);
  }

  @Test
  public void rectanglesAreReadWithTheirPlace() {
    PhoneCamera camera = new PhoneCamera().with(
        CameraCharacteristics.SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE,
        new Rect(10, 20, 4010, 3020));
    PixelRect array =
        new CameraReport(camera.characteristics()).facts(new Size(640, 480)).preCorrectionArray;
    assertEquals(10, array.left);
    assertEquals(20, array.top);
    assertEquals(4000, array.width);
    assertEquals(3000, array.height);
  }

  @Test
  public void theNearestSizeOfTheSameShapeIsTaken() {
    Size[] offered = {new Size(640, 360), new Size(1280, 960), new Size(800, 600)};
    assertEquals(new Size(800, 600), StreamChoice.size(offered, new Size(640, 480)));
    assertEquals(new Size(640, 360), StreamChoice.size(offered, new Size(640, 360)));
    Size[] wide = {new Size(1920, 1080), new Size(640, 360)};
    assertEquals(new Size(640, 360), StreamChoice.size(wide, new Size(640, 480)));
  }

  @Test
  public void aLensThatAlwaysStabilisesIsTold() {
    CameraReport report = new CameraReport(new PhoneCamera().characteristics());
    assertTrue(report.has(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION, 0));
    assertFalse(report.has(CameraCharacteristics.LENS_INFO_AVAILABLE_OPTICAL_STABILIZATION, 2));
  }
}
