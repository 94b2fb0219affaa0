package io.github.glideslam.sample;

import android.opengl.GLES11Ext;
import android.opengl.GLES20;
import io.github.glideslam.android.DisplayTransform;
import java.nio.FloatBuffer;

/** The camera's image, filling the view. GL thread. */
final class CameraBackground {
  private static final String VERTEX =
      "attribute vec2 corner;\n"
          + "attribute vec2 image;\n"
          + "varying vec2 at;\n"
          + "void main() { at = image; gl_Position = vec4(corner, 1.0, 1.0); }\n";
  private static final String FRAGMENT =
      "#extension GL_OES_EGL_image_external : require\n"
          + "precision mediump float;\n"
          + "uniform samplerExternalOES camera;\n"
          + "varying vec2 at;\n"
          + "void main() { gl_FragColor = texture2D(camera, at); }\n";

  private final FloatBuffer corners = Floats.of(new float[] {-1, -1, 1, -1, -1, 1, 1, 1});
  private final GlProgram program = new GlProgram(VERTEX, FRAGMENT);
  private final int corner = program.attribute("corner");
  private final int image = program.attribute("image");
  private FloatBuffer imageCorners = Floats.of(new float[8]);

  void setTransform(DisplayTransform transform) {
    imageCorners = Floats.of(transform.cornerTextureCoordinates());
  }

  void draw(int texture) {
    program.use();
    GLES20.glActiveTexture(GLES20.GL_TEXTURE0);
    GLES20.glBindTexture(GLES11Ext.GL_TEXTURE_EXTERNAL_OES, texture);
    GLES20.glUniform1i(program.uniform("camera"), 0);
    GLES20.glDepthMask(false);
    GLES20.glEnableVertexAttribArray(corner);
    GLES20.glEnableVertexAttribArray(image);
    GLES20.glVertexAttribPointer(corner, 2, GLES20.GL_FLOAT, false, 0, corners);
    GLES20.glVertexAttribPointer(image, 2, GLES20.GL_FLOAT, false, 0, imageCorners);
    GLES20.glDrawArrays(GLES20.GL_TRIANGLE_STRIP, 0, 4);
    GLES20.glDisableVertexAttribArray(corner);
    GLES20.glDisableVertexAttribArray(image);
    GLES20.glDepthMask(true);
  }
}
