package io.github.glideslam;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/** What a session is made with. Setters return this; a session keeps a copy. */
public final class Config {
  /** Where the direct tracker runs. */
  public enum Backend {
    /** OpenGL ES 3.1 compute when a hardware context is current in the first update, else the CPU. */
    AUTO,
    /** OpenGL ES 3.1 compute; without a context update throws MissingGlContextException. */
    GLES,
    /** The CPU. */
    CPU
  }

  /** What a session does with its map. */
  public enum Mode {
    /** Extends and corrects it. */
    SLAM,
    /** Only finds the camera in a loaded map. */
    LOCALIZATION_ONLY
  }

  /** Of which frames {@link Frame#getTrackedPoints} tells the points. */
  public enum ReportPoints {
    /** Of none, at no cost. */
    OFF,
    /** Of those that the indirect tracker found: microseconds. */
    INDIRECT,
    /** Of all that are tracked: direct ones cost some 0.2 ms more, at 752x480. */
    ON
  }

  private final CameraIntrinsics camera;
  private final StringBuilder settings = new StringBuilder();
  private Backend backend = Backend.AUTO;
  private Mode mode = Mode.SLAM;
  private boolean deterministic;

  /** Of a camera whose frames have the size that {@code camera} tells. */
  public Config(CameraIntrinsics camera) {
    if (camera == null) {
      throw new InvalidArgumentException("camera is null");
    }
    this.camera = camera;
  }

  Config(Config other) {
    this(other.camera);
    settings.append(other.settings);
    backend = other.backend;
    mode = other.mode;
    deterministic = other.deterministic;
  }

  /** AUTO unless set. */
  public Config setBackend(Backend value) {
    backend = notNull(value, "backend");
    return this;
  }

  /** SLAM unless set. */
  public Config setMode(Mode value) {
    mode = notNull(value, "mode");
    return this;
  }

  /**
   * Mapping inside update: slower frames, the same result on every run. For tests, and for files that
   * are fed faster than the camera took them: without it, frames are over before the map that they
   * start is there ({@link Session#waitForMapping} after each update does, too).
   */
  public Config setDeterministic(boolean value) {
    deterministic = value;
    return this;
  }

  /**
   * Any field of glide/config.h, for instance {@code set("direct.patch_size", "7")}. A misspelt name
   * is refused by the session's constructor.
   */
  public Config set(String name, String value) {
    String setting = notNull(name, "name") + "=" + notNull(value, "value");
    if (setting.indexOf('\0') >= 0) {
      throw new InvalidArgumentException("a setting contains a zero");
    }
    settings.append(setting).append('\0');
    return this;
  }

  /**
   * Folder where compiled shaders and what was tuned to the device are kept between starts: an app's
   * cache folder.
   */
  public Config setGlCacheDir(String path) {
    return set("gl.cache_dir", path);
  }

  /** OFF unless set. */
  public Config setTrackedPoints(ReportPoints value) {
    return set("tracked_points", notNull(value, "trackedPoints").name().toLowerCase(Locale.ROOT));
  }

  /** As given. */
  public CameraIntrinsics getCamera() {
    return camera;
  }

  byte[] settings() {
    return settings.toString().getBytes(StandardCharsets.UTF_8);
  }

  ByteBuffer struct() {
    ByteBuffer struct = Layout.struct(Layout.CONFIG_SIZE);
    struct.putInt(Layout.CONFIG_BACKEND, backend.ordinal());
    struct.putInt(Layout.CONFIG_MODE, mode.ordinal());
    struct.putInt(Layout.CONFIG_EXECUTION, deterministic ? 1 : 0);
    camera.write(struct, Layout.CONFIG_CAMERA);
    return struct;
  }

  private static <T> T notNull(T value, String name) {
    if (value == null) {
      throw new InvalidArgumentException(name + " is null");
    }
    return value;
  }
}
