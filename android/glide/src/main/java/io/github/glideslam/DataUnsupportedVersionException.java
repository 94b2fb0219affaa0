package io.github.glideslam;

/** A map of another version of the format. */
public class DataUnsupportedVersionException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public DataUnsupportedVersionException(String message) {
    super(-19, message);
  }
}
