package io.github.glideslam.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.glideslam.CameraIntrinsics;
import io.github.glideslam.UnsupportedConfigurationException;
import org.junit.Test;

public final class CameraIntrinsicsConverterTest {
  private static final float EXACT = 1e-4f;
  private static final double[] NONE = {};

  /** A sensor of 4000x3000, streamed as 640x480, with its axis in the middle. */
  private static CameraFacts phone() {
    CameraFacts facts = new CameraFacts();
    facts.preCorrectionArray = new PixelRect(0, 0, 4000, 3000);
    facts.activeArray = facts.preCorrectionArray;
    facts.pixelArrayWidth = 4000;
    facts.pixelArrayHeight = 3000;
    facts.intrinsicCalibration = new float[] {3200, 3300, 2000, 1500, 0};
    facts.focalLengthMm = 4;
    facts.sensorWidthMm = 5;
    facts.sensorHeightMm = 3.75f;
    facts.streamWidth = 640;
    facts.streamHeight = 480;
    return facts;
  }

  private static CameraIntrinsics intrinsics(CameraFacts facts) {
    return CameraIntrinsicsConverter.convert(facts).getIntrinsics();
  }

  private static void assertLens(
      CameraIntrinsics camera, double fx, double fy, double cx, double cy) {
    float[] focal = {(float) fx, (float) fy};
    float[] centre = {(float) cx, (float) cy};
    assertArrayEquals(focal, camera.getFocalLength(), EXACT);
    assertArrayEquals(centre, camera.getPrincipalPoint(), EXACT);
  }

  @Test
  public void scalesAndCountsFromTheCentreOfTheFirstPixel() {
    // An axis in the very middle stays there: (640 - 1) / 2 where (0, 0) is the first centre.
    assertLens(intrinsics(phone()), 512, 528, 319.5, 239.5);
    assertArrayEquals(new int[] {640, 480}, intrinsics(phone()).getImageDimensions());
  }

  @Test
  public void keepsTheWholeSensorsCalibrationButForHalfAPixel() {
    CameraFacts facts = phone();
    facts.streamWidth = 4000;
    facts.streamHeight = 3000;
    assertLens(intrinsics(facts), 3200, 3300, 1999.5, 1499.5);
  }

  @Test
  public void cutsTopAndBottomOffForWiderStreams() {
    CameraFacts facts = phone();
    facts.streamWidth = 1280;
    facts.streamHeight = 720;
    facts.intrinsicCalibration[3] = 1400;
    // 4000 x 2250 of 4000 x 3000: 375 rows less above; then 0.32.
    assertLens(intrinsics(facts), 1024, 1056, 639.5, (1400 - 375) * 0.32 - 0.5);
  }

  @Test
  public void cutsTheSidesOffForNarrowerStreams() {
    CameraFacts facts = phone();
    facts.streamWidth = 480;
    facts.streamHeight = 480;
    facts.intrinsicCalibration[2] = 2100;
    assertLens(intrinsics(facts), 512, 528, (2100 - 500) * 0.16 - 0.5, 239.5);
  }

  @Test
  public void followsTheCropRegion() {
    CameraFacts facts = phone();
    facts.crop = new PixelRect(1000, 700, 2000, 1500);
    assertLens(intrinsics(facts), 1024, 1056, (2000 - 1000) * 0.32 - 0.5, (1500 - 700) * 0.32 - 0.5);
  }

  @Test
  public void reordersTheDistortion() {
    CameraFacts facts = phone();
    facts.distortion = new float[] {0.1f, 0.2f, 0.3f, 0.4f, 0.5f};
    CameraIntrinsics camera = intrinsics(facts);
    assertEquals(CameraIntrinsics.Distortion.RADIAL_TANGENTIAL, camera.getDistortion());
    double[] openCv = {0.1, 0.2, 0.4, 0.5, 0.3};
    assertArrayEquals(openCv, camera.getCoefficients(), 1e-6);
  }

  /** Both formulas as their documentation has them, on a point off the axis. */
  @Test
  public void reorderedCoefficientsMovePointsAsAndroidSays() {
    CameraFacts facts = phone();
    float[] k = {0.11f, -0.07f, 0.05f, 0.003f, -0.002f};
    facts.distortion = k;
    double[] o = intrinsics(facts).getCoefficients();
    double x = 0.31;
    double y = -0.22;
    double r2 = x * x + y * y;
    double android = x * (1 + k[0] * r2 + k[1] * r2 * r2 + k[2] * r2 * r2 * r2)
        + k[3] * (2 * x * y) + k[4] * (r2 + 2 * x * x);
    double openCv = x * (1 + o[0] * r2 + o[1] * r2 * r2 + o[4] * r2 * r2 * r2)
        + 2 * o[2] * x * y + o[3] * (r2 + 2 * x * x);
    assertEquals(android, openCv, 1e-9);
  }

  @Test
  public void dropsTheDistortionThatTheCameraCorrects() {
    CameraFacts facts = phone();
    facts.distortion = new float[] {0.1f, 0.2f, 0.3f, 0.4f, 0.5f};
    facts.correction = CameraFacts.Correction.ON;
    assertEquals(CameraIntrinsics.Distortion.NONE, intrinsics(facts).getDistortion());
    assertArrayEquals(NONE, intrinsics(facts).getCoefficients(), 0);
  }

  @Test
  public void dropsADistortionOfZeros() {
    CameraFacts facts = phone();
    facts.distortion = new float[5];
    assertEquals(CameraIntrinsics.Distortion.NONE, intrinsics(facts).getDistortion());
  }

  /** The example of SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE: 10 pixels less on each side. */
  @Test
  public void movesFromThePreCorrectionArrayToTheActiveOne() {
    CameraFacts facts = phone();
    facts.preCorrectionArray = new PixelRect(10, 10, 4020, 3020);
    facts.activeArray = new PixelRect(20, 20, 4000, 3000);
    facts.intrinsicCalibration = new float[] {3200, 3300, 2010, 1510, 0};
    facts.correction = CameraFacts.Correction.ON;
    assertLens(intrinsics(facts), 512, 528, 319.5, 239.5);
  }

  @Test
  public void staysInThePreCorrectionArrayWithoutCorrection() {
    CameraFacts facts = phone();
    facts.preCorrectionArray = new PixelRect(10, 10, 4800, 3600);
    facts.activeArray = new PixelRect(20, 20, 4000, 3000);
    facts.intrinsicCalibration = new float[] {3600, 3600, 2400, 1800, 0};
    facts.correction = CameraFacts.Correction.OFF;
    assertLens(intrinsics(facts), 480, 480, 319.5, 239.5);
  }

  @Test
  public void estimatesFromFocalLengthAndSensorSizeWhenThereIsNoCalibration() {
    CameraFacts facts = phone();
    facts.intrinsicCalibration = null;
    facts.distortion = new float[] {0.1f, 0.2f, 0.3f, 0.4f, 0.5f};
    CameraCalibration calibration = CameraIntrinsicsConverter.convert(facts);
    assertTrue(calibration.isEstimated());
    // 4 mm on a sensor of 5 mm: 0.8 widths.
    assertLens(calibration.getIntrinsics(), 512, 512, 319.5, 239.5);
    assertEquals(
        CameraIntrinsics.Distortion.NONE, calibration.getIntrinsics().getDistortion());
    assertFalse(CameraIntrinsicsConverter.convert(phone()).isEstimated());
  }

  @Test
  public void takesCalibrationsThatCannotBeForNone() {
    float[][] wrong = {
      {0, 0, 0, 0, 0}, {3200, 3200, 0, 0, 0}, {3200, 3200, 5000, 1500, 0},
      {Float.NaN, 3200, 2000, 1500, 0}, {3200}
    };
    for (float[] lens : wrong) {
      CameraFacts facts = phone();
      facts.intrinsicCalibration = lens;
      assertTrue(CameraIntrinsicsConverter.convert(facts).isEstimated());
    }
  }

  @Test
  public void refusesACameraThatTellsNothing() {
    CameraFacts facts = phone();
    facts.intrinsicCalibration = null;
    facts.focalLengthMm = 0;
    assertThrows(
        UnsupportedConfigurationException.class, () -> CameraIntrinsicsConverter.convert(facts));
  }
}
