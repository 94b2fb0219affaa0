package io.github.glideslam;

import java.nio.charset.StandardCharsets;

/**
 * What every call of the library that fails throws: one subclass per status of glide.h. Nothing has
 * changed then. A camera that sees nothing is no failure but a {@link TrackingState}.
 */
public class GlideException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int status;

  /** {@code status} is a negative number of glide.h. */
  public GlideException(int status, String message) {
    super(message);
    this.status = status;
  }

  /** The number of the status in glide.h. */
  public final int getStatus() {
    return status;
  }

  /** The exception of a status; JNI throws it. */
  static GlideException of(int status, byte[] utf8) {
    String message = new String(utf8, StandardCharsets.UTF_8);
    switch (status) {
      case -1:
        return new InvalidArgumentException(message);
      case -2:
        return new FatalException(message);
      case -3:
        return new SessionPausedException(message);
      case -5:
        return new NotTrackingException(message);
      case -7:
        return new MissingGlContextException(message);
      case -8:
        return new UnsupportedConfigurationException(message);
      case -11:
        return new ResourceExhaustedException(message);
      case -12:
        return new NotYetAvailableException(message);
      case -18:
        return new DataInvalidFormatException(message);
      case -19:
        return new DataUnsupportedVersionException(message);
      default:
        return ofOurOwn(status, message);
    }
  }

  /** Those that ARCore does not have. */
  private static GlideException ofOurOwn(int status, String message) {
    switch (status) {
      case -100:
        return new SessionClosedException(message);
      case -101:
        return new WrongThreadException(message);
      case -102:
        return new TimestampOrderException(message);
      case -103:
        return new MapIoException(message);
      case -104:
        return new GlException(message);
      default:
        return new GlideException(status, message);
    }
  }
}
