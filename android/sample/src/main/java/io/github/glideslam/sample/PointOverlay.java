package io.github.glideslam.sample;

import android.opengl.GLES20;
import io.github.glideslam.TrackedPoints;
import io.github.glideslam.android.DisplayTransform;
import java.nio.FloatBuffer;

/**
 * What a frame was tracked by, as dots on the camera's image: green where it agrees with the pose, red
 * where not. GL thread.
 */
final class PointOverlay {
  private static final String VERTEX =
      "attribute vec3 point;\n"
          + "varying float inlier;\n"
          + "void main() {\n"
          + "  inlier = point.z;\n"
          + "  gl_PointSize = 6.0;\n"
          + "  gl_Position = vec4(point.xy, 0.0, 1.0);\n"
          + "}\n";
  private static final String FRAGMENT =
      "precision mediump float;\n"
          + "varying float inlier;\n"
          + "void main() { gl_FragColor = vec4(1.0 - inlier, inlier, 0.2, 1.0); }\n";
  // x and y in clip space, and 1 for an inlier.
  private static final int FLOATS_PER_POINT = 3;
  // More than a session with the default settings tracks.
  private static final int MOST_POINTS = 2048;

  private final GlProgram program = new GlProgram(VERTEX, FRAGMENT);
  private final int point = program.attribute("point");
  private final FloatBuffer vertices = Floats.of(new float[MOST_POINTS * FLOATS_PER_POINT]);
  private final float[] at = new float[2];

  /** {@code transform} tells how the image lies in a view of {@code width} x {@code height} pixels. */
  void draw(TrackedPoints points, DisplayTransform transform, int width, int height) {
    int count = Math.min(points.size(), MOST_POINTS);
    for (int i = 0; i < count; ++i) {
      transform.imageToView(points.getX(i), points.getY(i), at);
      vertices.put(2 * at[0] / width - 1).put(1 - 2 * at[1] / height);
      vertices.put(points.isInlier(i) ? 1 : 0);
    }
    vertices.rewind();
    program.use();
    GLES20.glEnableVertexAttribArray(point);
    GLES20.glVertexAttribPointer(point, FLOATS_PER_POINT, GLES20.GL_FLOAT, false, 0, vertices);
    GLES20.glDrawArrays(GLES20.GL_POINTS, 0, count);
    GLES20.glDisableVertexAttribArray(point);
  }
}
