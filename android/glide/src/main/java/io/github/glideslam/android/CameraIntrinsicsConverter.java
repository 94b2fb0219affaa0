package io.github.glideslam.android;

import io.github.glideslam.CameraIntrinsics;
import io.github.glideslam.UnsupportedConfigurationException;

/**
 * Android's calibration, of the whole sensor, to that of a stream's images in OpenCV's conventions.
 * No Android types: runs anywhere.
 *
 * <ul>
 *   <li>LENS_INTRINSIC_CALIBRATION counts from the corner of the pre-correction array, and the
 *       centre of its first pixel is (0.5, 0.5); OpenCV's is (0, 0).
 *   <li>A stream shows the centre of the crop region that has the stream's aspect, scaled.
 *   <li>LENS_DISTORTION (k1 k2 k3 k4 k5) is OpenCV's (k1 k2 p1 p2 k3) = (k1 k2 k4 k5 k3). It does
 *       not apply to images that the camera corrects.
 *   <li>The skew is left out: the library's model has none.
 * </ul>
 */
public final class CameraIntrinsicsConverter {
  private static final int CALIBRATION_VALUES = 4;
  private static final int DISTORTION_VALUES = 5;
  // From Android's centre of the first pixel to OpenCV's.
  private static final double PIXEL_CENTRE = 0.5;

  private final CameraFacts facts;
  /** The array in whose coordinates the camera crops. */
  private final PixelRect array;

  private CameraIntrinsicsConverter(CameraFacts facts) {
    this.facts = facts;
    array = facts.correction == CameraFacts.Correction.OFF
        ? facts.preCorrectionArray
        : facts.activeArray;
  }

  /** UnsupportedConfigurationException when a camera tells nothing from which this would follow. */
  public static CameraCalibration convert(CameraFacts facts) {
    return new CameraIntrinsicsConverter(facts).calibration();
  }

  private CameraCalibration calibration() {
    if (!isCalibrated()) {
      return new CameraCalibration(ofStream(estimate(), new double[0]), true);
    }
    double[] lens = new double[CALIBRATION_VALUES];
    for (int i = 0; i < lens.length; ++i) {
      lens[i] = facts.intrinsicCalibration[i];
    }
    lens[2] += facts.preCorrectionArray.left - array.left;
    lens[3] += facts.preCorrectionArray.top - array.top;
    return new CameraCalibration(ofStream(lens, coefficients()), false);
  }

  /** Some devices tell zeros instead of nothing. */
  private boolean isCalibrated() {
    float[] lens = facts.intrinsicCalibration;
    if (lens == null || lens.length < CALIBRATION_VALUES) {
      return false;
    }
    PixelRect sensor = facts.preCorrectionArray;
    // All false for not a number.
    boolean hasFocus = lens[0] > 0 && lens[1] > 0;
    boolean hasCentre =
        lens[2] > 0 && lens[2] < sensor.width && lens[3] > 0 && lens[3] < sensor.height;
    return hasFocus && hasCentre;
  }

  /** {fx, fy, cx, cy} in pixels of the array: the axis in its middle. */
  private double[] estimate() {
    if (!(facts.focalLengthMm > 0 && facts.sensorWidthMm > 0 && facts.sensorHeightMm > 0)) {
      throw new UnsupportedConfigurationException(
          "the camera tells neither its calibration nor its focal length and size");
    }
    return new double[] {
      (double) facts.focalLengthMm * facts.pixelArrayWidth / facts.sensorWidthMm,
      (double) facts.focalLengthMm * facts.pixelArrayHeight / facts.sensorHeightMm,
      array.width / 2.0,
      array.height / 2.0
    };
  }

  private double[] coefficients() {
    float[] kappa = facts.distortion;
    if (kappa == null || kappa.length < DISTORTION_VALUES
        || facts.correction == CameraFacts.Correction.ON) {
      return new double[0];
    }
    boolean isZero = true;
    for (float value : kappa) {
      isZero &= value == 0;
    }
    return isZero
        ? new double[0]
        : new double[] {kappa[0], kappa[1], kappa[3], kappa[4], kappa[2]};
  }

  /** From {fx, fy, cx, cy} of the array to those of the stream. */
  private CameraIntrinsics ofStream(double[] lens, double[] coefficients) {
    PixelRect crop =
        facts.crop != null ? facts.crop : new PixelRect(0, 0, array.width, array.height);
    double aspect = (double) facts.streamWidth / facts.streamHeight;
    double width = Math.min(crop.width, crop.height * aspect);
    double height = Math.min(crop.height, crop.width / aspect);
    double left = crop.left + (crop.width - width) / 2;
    double top = crop.top + (crop.height - height) / 2;
    double scale = facts.streamWidth / width;
    return new CameraIntrinsics(
        facts.streamWidth, facts.streamHeight, lens[0] * scale, lens[1] * scale,
        (lens[2] - left) * scale - PIXEL_CENTRE, (lens[3] - top) * scale - PIXEL_CENTRE,
        coefficients.length == 0
            ? CameraIntrinsics.Distortion.NONE
            : CameraIntrinsics.Distortion.RADIAL_TANGENTIAL,
        coefficients);
  }
}
