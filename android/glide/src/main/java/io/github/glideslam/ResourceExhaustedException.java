package io.github.glideslam;

/** Too many objects of a kind are held. */
public class ResourceExhaustedException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public ResourceExhaustedException(String message) {
    super(-11, message);
  }
}
