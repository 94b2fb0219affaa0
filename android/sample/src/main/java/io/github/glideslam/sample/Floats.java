package io.github.glideslam.sample;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;

/** Buffers that OpenGL reads. */
final class Floats {
  static FloatBuffer of(float[] values) {
    FloatBuffer buffer = ByteBuffer.allocateDirect(values.length * Float.BYTES)
        .order(ByteOrder.nativeOrder())
        .asFloatBuffer();
    buffer.put(values).rewind();
    return buffer;
  }

  private Floats() {}
}
