package io.github.glideslam;

import java.io.IOException;

/** A map could not be read or written. */
public class MapIoException extends GlideException {
  private static final long serialVersionUID = 1L;
  private static final int STATUS = -103;

  /** {@code message} tells what failed. */
  public MapIoException(String message) {
    super(STATUS, message);
  }

  /** The failure of an app's stream. */
  public MapIoException(IOException cause) {
    super(STATUS, String.valueOf(cause.getMessage()));
    initCause(cause);
  }
}
