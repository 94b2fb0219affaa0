package io.github.glideslam.android;

/**
 * What a camera tells about its lens and its stream: the input of {@link
 * CameraIntrinsicsConverter}. Plain values, named after the keys of CameraCharacteristics.
 */
public final class CameraFacts {
  /** Who takes the lens' distortion out of the images (DISTORTION_CORRECTION_MODE). */
  public enum Correction {
    /** Nobody, and no app can ask for it: the key is not there. */
    NOT_CONTROLLED,
    /** Nobody: OFF. */
    OFF,
    /** The camera: FAST or HIGH_QUALITY. */
    ON
  }

  /** SENSOR_INFO_PRE_CORRECTION_ACTIVE_ARRAY_SIZE, within the pixel array. */
  public PixelRect preCorrectionArray;
  /** SENSOR_INFO_ACTIVE_ARRAY_SIZE, within the pixel array. */
  public PixelRect activeArray;
  /** SENSOR_INFO_PIXEL_ARRAY_SIZE: the pixels across {@link #sensorWidthMm}. */
  public int pixelArrayWidth;
  /** The pixels across {@link #sensorHeightMm}. */
  public int pixelArrayHeight;

  /** LENS_INTRINSIC_CALIBRATION: fx fy cx cy skew; null on many devices. */
  public float[] intrinsicCalibration;
  /** LENS_DISTORTION: k1 k2 k3, then the two tangential ones; null on many devices. */
  public float[] distortion;
  /** What the capture requests ask for. */
  public Correction correction = Correction.NOT_CONTROLLED;
  /**
   * SCALER_CROP_REGION of the capture requests; null: everything. Within the pre-correction array
   * when the correction is OFF, within the active array otherwise.
   */
  public PixelRect crop;

  /** LENS_INFO_AVAILABLE_FOCAL_LENGTHS, the one in use; 0 when not known. */
  public float focalLengthMm;
  /** SENSOR_INFO_PHYSICAL_SIZE; 0 when not known. */
  public float sensorWidthMm;
  /** SENSOR_INFO_PHYSICAL_SIZE; 0 when not known. */
  public float sensorHeightMm;

  /** Of the images that are tracked. */
  public int streamWidth;
  /** Of the images that are tracked. */
  public int streamHeight;
}
