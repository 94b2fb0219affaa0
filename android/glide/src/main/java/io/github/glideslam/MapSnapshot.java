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

  /** A place that was recognised: two keyframes see the same landmarks; immutable. */
  public static final class Loop {
    private final long newerId;
    private final long olderId;

    private Loop(ByteBuffer structs, int at) {
      newerId = structs.getLong(at);
      olderId = structs.getLong(at + Layout.LOOP_OLDER);
    }

    /** Id of the keyframe that came back. */
    public long getNewerId() {
      return newerId;
    }

    /** Id of the keyframe that had been there. */
    public long getOlderId() {
      return olderId;
    }
  }

  private long handle;

  MapSnapshot(long handle) {
    this.handle = handle;
  }

  /** Grows from snapshot to snapshot when the map has changed. */
  public synchronized long getRevision() {
    return Native.mapRevision(handle());
  }

  /**
   * As {@link Frame#getMapGeneration}: scale and gravity are arbitrary again when it grows, and poses
   * and points of different generations are of different worlds.
   */
  public synchronized long getGeneration() {
    return Native.mapGeneration(handle());
  }

  /** All landmarks, in the world. A copy: it may outlive this. */
  public synchronized PointCloud getPoints() {
    return PointCloud.ofMap(handle());
  }

  /** All keyframes, the oldest first. A copy: it may outlive this. */
  public synchronized List<Keyframe> getKeyframes() {
    int count = Native.mapKeyframes(handle(), null);
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

  /** All places that were recognised. A copy: it may outlive this. */
  public synchronized List<Loop> getLoops() {
    int count = Native.mapLoops(handle(), null);
    ByteBuffer structs = Layout.array(count, Layout.LOOP_SIZE);
    if (count > 0) {
      Native.mapLoops(handle, structs);
    }
    List<Loop> loops = new ArrayList<>(count);
    for (int i = 0; i < count; ++i) {
      loops.add(new Loop(structs, i * Layout.LOOP_SIZE));
    }
    return Collections.unmodifiableList(loops);
  }

  /**
   * The camera as the map has corrected it: poses are of this camera. NotYetAvailableException while
   * it is as it was given.
   */
  public synchronized CameraIntrinsics getCorrectedCamera() {
    ByteBuffer struct = Layout.array(1, Layout.CAMERA_SIZE);
    Native.mapCorrectedCamera(handle(), struct);
    return CameraIntrinsics.read(struct);
  }

  /** Frees the native memory; more than once is fine. Everything else then throws. */
  @Override
  public synchronized void close() {
    long closing = handle;
    handle = 0;
    Native.releaseMap(closing);
  }

  private long handle() {
    if (handle == 0) {
      throw new SessionClosedException("the map snapshot is closed");
    }
    return handle;
  }
}
