package io.github.glideslam;

/** What was asked for does not exist yet. */
public class NotYetAvailableException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public NotYetAvailableException(String message) {
    super(-12, message);
  }
}
