package io.github.glideslam;

/** The session is paused: call {@link Session#resume} first. */
public class SessionPausedException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public SessionPausedException(String message) {
    super(-3, message);
  }
}
