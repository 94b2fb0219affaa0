package io.github.glideslam;

/** OpenGL failed. */
public class GlException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public GlException(String message) {
    super(-104, message);
  }
}
