package io.github.glideslam.sample;

import android.opengl.GLES20;
import io.github.glideslam.PointCloud;

/** Landmarks as dots: green where they are sure, red where not. GL thread. */
final class PointOverlay {
  private static final String VERTEX =
      "uniform mat4 clipFromWorld;\n"
          + "attribute vec4 landmark;\n"
          + "varying float confidence;\n"
          + "void main() {\n"
          + "  confidence = landmark.w;\n"
          + "  gl_PointSize = 6.0;\n"
          + "  gl_Position = clipFromWorld * vec4(landmark.xyz, 1.0);\n"
          + "}\n";
  private static final String FRAGMENT =
      "precision mediump float;\n"
          + "varying float confidence;\n"
          + "void main() { gl_FragColor = vec4(1.0 - confidence, confidence, 0.2, 1.0); }\n";

  private final GlProgram program = new GlProgram(VERTEX, FRAGMENT);
  private final int landmark = program.attribute("landmark");
  private final int clipFromWorld = program.uniform("clipFromWorld");

  void draw(PointCloud points, float[] matrix) {
    program.use();
    GLES20.glUniformMatrix4fv(clipFromWorld, 1, false, matrix, 0);
    GLES20.glEnableVertexAttribArray(landmark);
    GLES20.glVertexAttribPointer(
        landmark, PointCloud.FLOATS_PER_POINT, GLES20.GL_FLOAT, false, 0, points.getPoints());
    GLES20.glDrawArrays(GLES20.GL_POINTS, 0, points.size());
    GLES20.glDisableVertexAttribArray(landmark);
  }
}
