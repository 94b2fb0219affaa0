package io.github.glideslam;

/** The call needs a tracked frame or a map, and there is none. */
public class NotTrackingException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public NotTrackingException(String message) {
    super(-5, message);
  }
}
