package io.github.glideslam;

/** A dependency failed, for instance for lack of memory. */
public class FatalException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public FatalException(String message) {
    super(-2, message);
  }
}
