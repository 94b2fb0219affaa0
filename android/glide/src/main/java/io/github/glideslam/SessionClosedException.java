package io.github.glideslam;

/** The session, map snapshot or point cloud was closed. */
public class SessionClosedException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public SessionClosedException(String message) {
    super(-100, message);
  }
}
