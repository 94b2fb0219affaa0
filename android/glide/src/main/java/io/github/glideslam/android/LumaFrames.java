package io.github.glideslam.android;

import android.graphics.ImageFormat;
import android.media.Image;
import android.media.ImageReader;
import android.view.Surface;
import io.github.glideslam.CameraInput;

/**
 * A camera's images as grey pixels in memory: for the CPU backend, and where the device's external
 * textures make trouble. One thread at a time.
 */
public final class LumaFrames implements AutoCloseable {
  // One that is tracked, one that is ready, one that the camera fills.
  private static final int IMAGES = 3;

  private final Camera2Source camera;
  private final ImageReader reader;
  private final CameraInput.Luma input;
  private final FrameTimings.Timing timing = new FrameTimings.Timing();
  private Image image;

  public LumaFrames(Camera2Source camera) {
    this.camera = camera;
    int width = camera.getSize().getWidth();
    int height = camera.getSize().getHeight();
    reader = ImageReader.newInstance(width, height, ImageFormat.YUV_420_888, IMAGES);
    input = new CameraInput.Luma(width, height);
  }

  /** For {@link Camera2Source#start}. */
  public Surface getSurface() {
    return reader.getSurface();
  }

  /**
   * The newest image, for Session.update; null when none has come since the last call. The same object
   * each time; its pixels are there until the next call.
   */
  public CameraInput acquire() {
    Image newest = reader.acquireLatestImage();
    if (newest == null) {
      return null;
    }
    closeImage();
    image = newest;
    Image.Plane luma = image.getPlanes()[0];
    input.set(
        luma.getBuffer(), luma.getRowStride(), luma.getPixelStride(), image.getTimestamp());
    camera.stamp(input, image.getTimestamp(), timing);
    return input;
  }

  /** When the camera is stopped. More than once is fine. */
  @Override
  public void close() {
    closeImage();
    reader.close();
  }

  private void closeImage() {
    if (image != null) {
      image.close();
      image = null;
    }
  }
}
