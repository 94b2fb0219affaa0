package io.github.glideslam;

/** A timestamp is not newer than the one before. */
public class TimestampOrderException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public TimestampOrderException(String message) {
    super(-102, message);
  }
}
