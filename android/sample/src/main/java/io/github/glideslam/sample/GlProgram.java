package io.github.glideslam.sample;

import android.opengl.GLES20;

/** Vertex and fragment shader, linked. GL thread. */
final class GlProgram {
  private final int name;

  GlProgram(String vertexShader, String fragmentShader) {
    name = GLES20.glCreateProgram();
    attach(GLES20.GL_VERTEX_SHADER, vertexShader);
    attach(GLES20.GL_FRAGMENT_SHADER, fragmentShader);
    GLES20.glLinkProgram(name);
    int[] linked = new int[1];
    GLES20.glGetProgramiv(name, GLES20.GL_LINK_STATUS, linked, 0);
    if (linked[0] == GLES20.GL_FALSE) {
      throw new IllegalStateException("shaders: " + GLES20.glGetProgramInfoLog(name));
    }
  }

  private void attach(int type, String source) {
    int shader = GLES20.glCreateShader(type);
    GLES20.glShaderSource(shader, source);
    GLES20.glCompileShader(shader);
    GLES20.glAttachShader(name, shader);
    GLES20.glDeleteShader(shader); // it goes with the program
  }

  void use() {
    GLES20.glUseProgram(name);
  }

  int attribute(String attribute) {
    return GLES20.glGetAttribLocation(name, attribute);
  }

  int uniform(String uniform) {
    return GLES20.glGetUniformLocation(name, uniform);
  }
}
