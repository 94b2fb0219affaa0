package io.github.glideslam;

/** The session, map or anchor was closed. */
public class SessionClosedException extends GlideException {
  private static final long serialVersionUID = 1L;

  public SessionClosedException(String message) {
    super(-100, message);
  }
}
