package io.github.glideslam;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/** Where a session's direct tracker runs; immutable. */
public final class BackendInfo {
  private static final int GLES = 1; // GLIDE_BACKEND_GLES

  private final Config.Backend backend;
  private final String vendor;
  private final String renderer;
  private final String version;

  BackendInfo(ByteBuffer struct) {
    boolean isGles = struct.getInt(Layout.BACKEND_KIND) == GLES;
    backend = isGles ? Config.Backend.GLES : Config.Backend.CPU;
    vendor = text(struct, Layout.BACKEND_VENDOR, Layout.BACKEND_RENDERER);
    renderer = text(struct, Layout.BACKEND_RENDERER, Layout.BACKEND_VERSION);
    version = text(struct, Layout.BACKEND_VERSION, Layout.BACKEND_SIZE);
  }

  private static String text(ByteBuffer struct, int begin, int end) {
    byte[] bytes = new byte[end - begin];
    int length = 0;
    for (; begin + length < end && struct.get(begin + length) != 0; ++length) {
      bytes[length] = struct.get(begin + length);
    }
    return new String(bytes, 0, length, StandardCharsets.UTF_8);
  }

  /** GLES or CPU; with AUTO it is decided in the first update. */
  public Config.Backend getBackend() {
    return backend;
  }

  /** GL_VENDOR; empty on the CPU. */
  public String getVendor() {
    return vendor;
  }

  /** GL_RENDERER; empty on the CPU. */
  public String getRenderer() {
    return renderer;
  }

  /** GL_VERSION; empty on the CPU. */
  public String getVersion() {
    return version;
  }
}
