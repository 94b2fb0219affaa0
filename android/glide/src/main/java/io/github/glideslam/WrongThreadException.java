package io.github.glideslam;

/** Another thread owns the session's GL objects: see {@link Session}. */
public class WrongThreadException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public WrongThreadException(String message) {
    super(-101, message);
  }
}
