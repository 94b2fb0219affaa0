package io.github.glideslam;

/** An argument is null, out of range or of the wrong kind; the message names it. */
public class InvalidArgumentException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public InvalidArgumentException(String message) {
    super(-1, message);
  }
}
