package io.github.glideslam.android;

import android.hardware.HardwareBuffer;
import io.github.glideslam.CameraInput;

/** A frame in a hardware buffer, for instance that of an Image; needs OpenGL ES. */
public final class HardwareBufferInput extends CameraInput.Hardware {
  /** Of frames of {@code width} x {@code height} pixels, the Config's. */
  public HardwareBufferInput(int width, int height) {
    super(width, height);
  }

  /**
   * The buffer must be made with USAGE_GPU_SAMPLED_IMAGE, be filled, and stay open until update
   * returns; null drops the last one. {@code transform} is that of a texture, or null: the first
   * row is the uppermost. Returns this.
   */
  public HardwareBufferInput set(HardwareBuffer buffer, float[] transform, long timestampNs) {
    setBuffer(buffer, transform, timestampNs);
    return this;
  }
}
