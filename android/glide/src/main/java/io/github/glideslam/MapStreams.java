package io.github.glideslam;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Maps between the library and where an app keeps them. MapIoException with the stream's as its cause. */
final class MapStreams {
  private static final int READ_STEP = 1 << 16;

  private MapStreams() {}

  static void write(byte[] map, OutputStream stream) {
    try {
      stream.write(map);
      stream.flush();
    } catch (IOException e) {
      throw new MapIoException(e);
    }
  }

  /** What is left of the stream. */
  static byte[] read(InputStream stream) {
    if (stream == null) {
      throw new InvalidArgumentException("stream is null");
    }
    ByteArrayOutputStream map = new ByteArrayOutputStream();
    byte[] piece = new byte[READ_STEP];
    try {
      for (int got = stream.read(piece); got >= 0; got = stream.read(piece)) {
        map.write(piece, 0, got);
      }
    } catch (IOException e) {
      throw new MapIoException(e);
    }
    return map.toByteArray();
  }

  /** As C takes it. */
  static byte[] path(String path) {
    if (path == null || path.indexOf('\0') >= 0) {
      throw new InvalidArgumentException("path is null or contains a zero");
    }
    return (path + '\0').getBytes(StandardCharsets.UTF_8);
  }
}
