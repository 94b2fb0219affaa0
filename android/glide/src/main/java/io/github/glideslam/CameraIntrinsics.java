package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * Calibration of the camera at the resolution of its frames, immutable. OpenCV's conventions: pixel
 * (0, 0) is the centre of the first pixel (Android's LENS_INTRINSIC_CALIBRATION minus 0.5).
 */
public final class CameraIntrinsics {
  /** Lens models, with their coefficients in OpenCV's order. */
  public enum Distortion {
    /** Pinhole. */
    NONE,
    /** Brown-Conrady: k1 k2 p1 p2 [k3]. */
    RADIAL_TANGENTIAL,
    /** Equidistant fisheye: k1 k2 k3 k4. */
    KANNALA_BRANDT4
  }

  private final int width;
  private final int height;
  private final double fx;
  private final double fy;
  private final double cx;
  private final double cy;
  private final Distortion distortion;
  private final double[] coefficients;

  /** A pinhole camera; all in pixels. */
  // NOLINTNEXTLINE(readability-function-size): a calibration is so many numbers
  public CameraIntrinsics(int width, int height, double fx, double fy, double cx, double cy) {
    this(width, height, fx, fy, cx, cy, Distortion.NONE);
  }

  /** With a lens; all in pixels but the coefficients. */
  // NOLINTNEXTLINE(readability-function-size): as above
  public CameraIntrinsics(
      int width, int height, double fx, double fy, double cx, double cy,
      Distortion distortion, double... coefficients) {
    if (distortion == null || coefficients == null
        || coefficients.length > Layout.CAMERA_MOST_COEFFICIENTS) {
      throw new InvalidArgumentException("distortion is null or has too many coefficients");
    }
    this.width = width;
    this.height = height;
    this.fx = fx;
    this.fy = fy;
    this.cx = cx;
    this.cy = cy;
    this.distortion = distortion;
    this.coefficients = coefficients.clone();
  }

  /** {width, height}. */
  public int[] getImageDimensions() {
    return new int[] {width, height};
  }

  /** {fx, fy}. */
  public float[] getFocalLength() {
    return new float[] {(float) fx, (float) fy};
  }

  /** {cx, cy}. */
  public float[] getPrincipalPoint() {
    return new float[] {(float) cx, (float) cy};
  }

  /** The lens model. */
  public Distortion getDistortion() {
    return distortion;
  }

  /** Of the lens model, in OpenCV's order. A copy. */
  public double[] getCoefficients() {
    return coefficients.clone();
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** The camera as images that are {@code width} pixels wide see it; the shape stays. */
  public CameraIntrinsics scaledTo(int newWidth) {
    double s = (double) newWidth / width;
    // Pixels' outer borders scale, centres do not lie on them.
    return new CameraIntrinsics(
        newWidth, (int) Math.round(height * s), fx * s, fy * s, (cx + 0.5) * s - 0.5,
        (cy + 0.5) * s - 0.5, distortion, coefficients);
  }

  /** Of a glide_intrinsics. */
  static CameraIntrinsics read(ByteBuffer struct) {
    double[] coefficients = new double[struct.getInt(Layout.CAMERA_COUNT)];
    for (int i = 0; i < coefficients.length; ++i) {
      coefficients[i] = struct.getDouble(Layout.CAMERA_COEFFICIENTS + Double.BYTES * i);
    }
    int f = Layout.CAMERA_FX;
    return new CameraIntrinsics(
        struct.getInt(Layout.CAMERA_WIDTH), struct.getInt(Layout.CAMERA_HEIGHT),
        struct.getDouble(f), struct.getDouble(f + 8), struct.getDouble(f + 16),
        struct.getDouble(f + 24),
        Distortion.values()[struct.getInt(Layout.CAMERA_DISTORTION)], coefficients);
  }

  /** Into a glide_intrinsics of a struct. */
  void write(ByteBuffer struct, int at) {
    struct.putInt(at + Layout.CAMERA_WIDTH, width).putInt(at + Layout.CAMERA_HEIGHT, height);
    int f = at + Layout.CAMERA_FX;
    struct.putDouble(f, fx).putDouble(f + 8, fy).putDouble(f + 16, cx).putDouble(f + 24, cy);
    struct.putInt(at + Layout.CAMERA_DISTORTION, distortion.ordinal());
    struct.putInt(at + Layout.CAMERA_COUNT, coefficients.length);
    for (int i = 0; i < coefficients.length; ++i) {
      struct.putDouble(at + Layout.CAMERA_COEFFICIENTS + 8 * i, coefficients[i]);
    }
  }
}
