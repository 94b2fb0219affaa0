package io.github.glideslam;

/** No OpenGL ES 3.1 context is current on this thread. */
public class MissingGlContextException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public MissingGlContextException(String message) {
    super(-7, message);
  }
}
