package io.github.glideslam;

/** The device or this build of the library cannot do it. */
public class UnsupportedConfigurationException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public UnsupportedConfigurationException(String message) {
    super(-8, message);
  }
}
