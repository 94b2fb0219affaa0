package io.github.glideslam.sample;

import android.opengl.GLES20;
import java.nio.ByteBuffer;
import java.nio.FloatBuffer;

/** A cube whose faces have colours, standing on the origin; edges of length 1. GL thread. */
final class Cube {
  private static final String VERTEX =
      "uniform mat4 clipFromCube;\n"
          + "attribute vec3 corner;\n"
          + "varying vec3 colour;\n"
          + "void main() {\n"
          + "  colour = vec3(corner.x + 0.5, corner.y, corner.z + 0.5);\n"
          + "  gl_Position = clipFromCube * vec4(corner, 1.0);\n"
          + "}\n";
  private static final String FRAGMENT =
      "precision mediump float;\n"
          + "varying vec3 colour;\n"
          + "void main() { gl_FragColor = vec4(0.2 + 0.8 * colour, 1.0); }\n";
  // Two triangles a face; bit 0 of a corner's number is x, bit 1 y, bit 2 z.
  private static final byte[] FACES = {
    0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5
  };

  private final GlProgram program = new GlProgram(VERTEX, FRAGMENT);
  private final int corner = program.attribute("corner");
  private final int clipFromCube = program.uniform("clipFromCube");
  private final FloatBuffer corners = Floats.of(corners());
  private final ByteBuffer faces = ByteBuffer.allocateDirect(FACES.length);

  Cube() {
    faces.put(FACES).rewind();
  }

  private static float[] corners() {
    float[] corners = new float[24];
    for (int i = 0; i < 8; ++i) {
      corners[3 * i] = (i & 1) - 0.5f;
      corners[3 * i + 1] = i >> 1 & 1;
      corners[3 * i + 2] = (i >> 2) - 0.5f;
    }
    return corners;
  }

  void draw(float[] matrix) {
    program.use();
    GLES20.glEnable(GLES20.GL_DEPTH_TEST);
    GLES20.glUniformMatrix4fv(clipFromCube, 1, false, matrix, 0);
    GLES20.glEnableVertexAttribArray(corner);
    GLES20.glVertexAttribPointer(corner, 3, GLES20.GL_FLOAT, false, 0, corners);
    GLES20.glDrawElements(GLES20.GL_TRIANGLES, FACES.length, GLES20.GL_UNSIGNED_BYTE, faces);
    GLES20.glDisableVertexAttribArray(corner);
    GLES20.glDisable(GLES20.GL_DEPTH_TEST);
  }
}
