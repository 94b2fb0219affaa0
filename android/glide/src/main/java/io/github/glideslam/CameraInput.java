package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * One camera frame. Make one object per camera and fill it again for each frame: nothing is
 * allocated then. It is read only during {@link Session#update}; pixels and textures must stay as
 * they are for as long as that call runs. Not for several threads at a time.
 */
public abstract class CameraInput {
  private static final int LUMA8 = 0;
  private static final int TEXTURE_2D = 1;
  private static final int TEXTURE_EXTERNAL = 2;
  private static final int HARDWARE_BUFFER = 3;

  final ByteBuffer struct = Layout.struct(Layout.IMAGE_SIZE);

  private CameraInput(int kind, int width, int height) {
    if (width <= 0 || height <= 0) {
      throw new InvalidArgumentException("width " + width + " or height " + height
          + " of the frames is not positive");
    }
    struct.putInt(Layout.IMAGE_KIND, kind);
    struct.putInt(Layout.IMAGE_WIDTH, width).putInt(Layout.IMAGE_HEIGHT, height);
  }

  /** Pixels in a row. */
  public final int getWidth() {
    return struct.getInt(Layout.IMAGE_WIDTH);
  }

  /** Rows. */
  public final int getHeight() {
    return struct.getInt(Layout.IMAGE_HEIGHT);
  }

  /** Nanoseconds in the camera's clock, strictly increasing from frame to frame. */
  public final void setTimestamp(long timestampNs) {
    struct.putLong(Layout.IMAGE_TIME, timestampNs);
  }

  /** Nanoseconds in the camera's clock. */
  public final long getTimestamp() {
    return struct.getLong(Layout.IMAGE_TIME);
  }

  /** Exposure time, nanoseconds; 0 when not known. Kept for later versions. */
  public final void setExposure(long exposureNs) {
    struct.putLong(Layout.IMAGE_EXPOSURE, exposureNs);
  }

  /**
   * From the start of the first row's exposure to that of the last, nanoseconds
   * (SENSOR_ROLLING_SHUTTER_SKEW); 0 when not known. Kept for later versions.
   */
  public final void setRollingShutterSkew(long skewNs) {
    struct.putLong(Layout.IMAGE_SKEW, skewNs);
  }

  /** The direct buffer that holds the pixels; null where there are none. */
  ByteBuffer pixels() {
    return null;
  }

  /** An android.hardware.HardwareBuffer; null where there is none. */
  Object hardwareBuffer() {
    return null;
  }

  final void setTransform(float[] transform) {
    if (transform != null && transform.length != 16) {
      throw new InvalidArgumentException("transform has " + transform.length + " elements, not 16");
    }
    for (int i = 0; i < 16; ++i) {
      struct.putFloat(
          Layout.IMAGE_TRANSFORM + Float.BYTES * i, transform == null ? 0 : transform[i]);
    }
  }

  /** 8-bit grey pixels in a direct buffer: Image.getPlanes()[0] of YUV_420_888. */
  public static final class Luma extends CameraInput {
    private ByteBuffer pixels;

    /** Of frames of {@code width} x {@code height} pixels, the {@link Config}'s. */
    public Luma(int width, int height) {
      super(LUMA8, width, height);
    }

    /**
     * The first pixel is at the buffer's position. InvalidArgumentException when the buffer is null,
     * not direct or too small for {@code rowStride} bytes from row to row, or when the pixel stride
     * is not 1. Returns this.
     */
    public Luma set(ByteBuffer buffer, int rowStride, int pixelStride, long timestampNs) {
      if (buffer == null || !buffer.isDirect()) {
        throw new InvalidArgumentException("buffer is null or not direct");
      }
      if (pixelStride != 1) {
        throw new InvalidArgumentException("pixelStride is " + pixelStride + ", 1 is needed");
      }
      if (rowStride < getWidth()) {
        throw new InvalidArgumentException(
            "rowStride is " + rowStride + ", the width is " + getWidth());
      }
      long needed = (long) rowStride * (getHeight() - 1) + getWidth();
      if (buffer.remaining() < needed) {
        throw new InvalidArgumentException(
            "buffer holds " + buffer.remaining() + " bytes, the image needs " + needed);
      }
      pixels = buffer;
      struct.putLong(Layout.IMAGE_PIXELS, buffer.position());
      struct.putLong(Layout.IMAGE_ROW_STRIDE, rowStride);
      setTimestamp(timestampNs);
      return this;
    }

    @Override
    ByteBuffer pixels() {
      if (pixels == null) {
        throw new InvalidArgumentException("CameraInput.Luma was given no pixels: call set()");
      }
      return pixels;
    }
  }

  /** A GL_TEXTURE_2D of the context that is current in update. */
  public static final class Texture extends CameraInput {
    /** Of frames of {@code width} x {@code height} pixels, the {@link Config}'s. */
    public Texture(int width, int height) {
      super(TEXTURE_2D, width, height);
    }

    /**
     * {@code name} is GL's, {@code transform} as of {@link ExternalTexture}, or null: the first row
     * is the uppermost. Returns this.
     */
    public Texture set(int name, float[] transform, long timestampNs) {
      struct.putInt(Layout.IMAGE_TEXTURE, name);
      setTransform(transform);
      setTimestamp(timestampNs);
      return this;
    }
  }

  /** A GL_TEXTURE_EXTERNAL_OES: what a SurfaceTexture gives. */
  public static final class ExternalTexture extends CameraInput {
    /** Of frames of {@code width} x {@code height} pixels, the {@link Config}'s. */
    public ExternalTexture(int width, int height) {
      super(TEXTURE_EXTERNAL, width, height);
    }

    /**
     * {@code name} is GL's, {@code transform} SurfaceTexture.getTransformMatrix's, {@code
     * timestampNs} its getTimestamp's, both after updateTexImage. Returns this.
     */
    public ExternalTexture set(int name, float[] transform, long timestampNs) {
      struct.putInt(Layout.IMAGE_TEXTURE, name);
      setTransform(transform);
      setTimestamp(timestampNs);
      return this;
    }
  }

  /**
   * What io.github.glideslam.android.HardwareBufferInput, which knows Android's type, is made of.
   * Other systems have no such buffers: update throws UnsupportedConfigurationException there.
   */
  public abstract static class Hardware extends CameraInput {
    private Object buffer;

    /** Of frames of {@code width} x {@code height} pixels, the {@link Config}'s. */
    protected Hardware(int width, int height) {
      super(HARDWARE_BUFFER, width, height);
    }

    /**
     * {@code hardwareBuffer} must be an android.hardware.HardwareBuffer and stay open until update
     * returns; null drops the last one. {@code transform} as of {@link Texture}.
     */
    protected final void setBuffer(Object hardwareBuffer, float[] transform, long timestampNs) {
      buffer = hardwareBuffer;
      setTransform(transform);
      setTimestamp(timestampNs);
    }

    @Override
    final Object hardwareBuffer() {
      if (buffer == null) {
        throw new InvalidArgumentException("CameraInput.Hardware was given no buffer");
      }
      return buffer;
    }
  }
}
