package io.github.glideslam;

/** The bytes are no sound map. */
public class DataInvalidFormatException extends GlideException {
  private static final long serialVersionUID = 1L;

  /** {@code message} tells why. */
  public DataInvalidFormatException(String message) {
    super(-18, message);
  }
}
