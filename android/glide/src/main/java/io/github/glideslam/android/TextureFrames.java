package io.github.glideslam.android;

import android.graphics.SurfaceTexture;
import android.opengl.GLES11Ext;
import android.opengl.GLES20;
import android.view.Surface;
import io.github.glideslam.CameraInput;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * A camera's images as an external texture: nothing is copied to the CPU. Made, used and released on
 * the thread whose GL context is current; a new context needs a new one. Frames are the sensor's
 * images, unturned: their intrinsics are the camera's.
 */
public final class TextureFrames {
  private static final int NO_TEXTURE = 0;

  private final Camera2Source camera;
  private final int texture;
  private final SurfaceTexture surfaceTexture;
  private final Surface surface;
  private final CameraInput.ExternalTexture input;
  private final FrameTimings.Timing timing = new FrameTimings.Timing();
  private final AtomicBoolean isNew = new AtomicBoolean();
  private long lastSensorNs = Long.MIN_VALUE;

  public TextureFrames(Camera2Source camera) {
    this.camera = camera;
    int[] names = new int[1];
    GLES20.glGenTextures(1, names, 0);
    texture = names[0];
    GLES20.glBindTexture(GLES11Ext.GL_TEXTURE_EXTERNAL_OES, texture);
    setParameter(GLES20.GL_TEXTURE_MIN_FILTER, GLES20.GL_LINEAR);
    setParameter(GLES20.GL_TEXTURE_MAG_FILTER, GLES20.GL_LINEAR);
    setParameter(GLES20.GL_TEXTURE_WRAP_S, GLES20.GL_CLAMP_TO_EDGE);
    setParameter(GLES20.GL_TEXTURE_WRAP_T, GLES20.GL_CLAMP_TO_EDGE);
    GLES20.glBindTexture(GLES11Ext.GL_TEXTURE_EXTERNAL_OES, NO_TEXTURE);
    int width = camera.getSize().getWidth();
    int height = camera.getSize().getHeight();
    surfaceTexture = new SurfaceTexture(texture);
    surfaceTexture.setDefaultBufferSize(width, height);
    surfaceTexture.setOnFrameAvailableListener(unused -> isNew.set(true));
    surface = new Surface(surfaceTexture);
    input = new CameraInput.ExternalTexture(width, height);
  }

  private static void setParameter(int name, int value) {
    GLES20.glTexParameteri(GLES11Ext.GL_TEXTURE_EXTERNAL_OES, name, value);
  }

  /** For {@link Camera2Source#start}. */
  public Surface getSurface() {
    return surface;
  }

  /** GL's name, of GL_TEXTURE_EXTERNAL_OES: shows the last frame; its first row is at t = 0. */
  public int getTextureName() {
    return texture;
  }

  /**
   * The newest image, for Session.update; null when none has come since the last call. The same object
   * each time. Leaves the texture bound to the active unit.
   */
  public CameraInput acquire() {
    if (!isNew.getAndSet(false)) {
      return null;
    }
    surfaceTexture.updateTexImage();
    long sensorNs = surfaceTexture.getTimestamp();
    if (sensorNs <= lastSensorNs) {
      return null;
    }
    lastSensorNs = sensorNs;
    // Not SurfaceTexture's matrix, which turns images upright: see the class comment.
    input.set(texture, null, sensorNs);
    camera.stamp(input, sensorNs, timing);
    return input;
  }

  /** When the camera is stopped, and while the context is current. */
  public void release() {
    abandon();
    GLES20.glDeleteTextures(1, new int[] {texture}, 0);
  }

  /** Instead of it, when the context is gone, and the texture with it. */
  public void abandon() {
    surface.release();
    surfaceTexture.release();
  }
}
