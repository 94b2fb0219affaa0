package io.github.glideslam;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The complete map at one revision, immutable: it stays readable, from any thread, also after its
 * session. Holds native memory until it is closed.
 */
public final class MapSnapshot implements AutoCloseable {
  /** A view that was kept for mapping; immutable. */
  public static final class Keyframe {
    private final long id;
    private final long timestampNs;
    private final Pose pose;
    private final boolean retired;

    private Keyframe(ByteBuffer structs, int at) {
      id = structs.getLong(at);
      timestampNs = structs.getLong(at + Layout.KEYFRAME_TIME);
      pose = Pose.read(structs, at + Layout.KEYFRAME_CAMERA);
      retired = structs.getInt(at + Layout.KEYFRAME_RETIRED) != 0;
    }

    /** Stays with the keyframe. */
    public long getId() {
      return id;
    }

    /** Nanoseconds in the camera's clock. */
    public long getTimestamp() {
      return timestampNs;
    }

    /** Camera in world, GL axes. */
    public Pose getPose() {
      return pose;
    }

    /** Whether it was culled; its pose stays defined. */
    public boolean isRetired() {
      return retired;
    }
  }

  private long handle;

  MapSnapshot(long handle) {
    this.handle = handle;
  }

  /** Grows from snapshot to snapshot when the map has changed. */
  public synchronized long getRevision() {
    return Native.mapRevision(handle);
  }

  /** All landmarks, in the world. A copy: it may outlive this. */
  public synchronized PointCloud getPoints() {
    return PointCloud.ofMap(handle);
  }

  /** All keyframes, the oldest first. A copy: it may outlive this. */
  public synchronized List<Keyframe> getKeyframes() {
    int count = Native.mapKeyframes(handle, null);
    ByteBuffer structs = Layout.array(count, Layout.KEYFRAME_SIZE);
    if (count > 0) {
      Native.mapKeyframes(handle, structs);
    }
    List<Keyframe> keyframes = new ArrayList<>(count);
    for (int i = 0; i < count; ++i) {
      keyframes.add(new Keyframe(structs, i * Layout.KEYFRAME_SIZE));
    }
    return Collections.unmodifiableList(keyframes);
  }

  /** Frees the native memory; more than once is fine. Everything else then throws. */
  @Override
  public synchronized void close() {
    long closing = handle;
    handle = 0;
    Native.releaseMap(closing);
  }
}
