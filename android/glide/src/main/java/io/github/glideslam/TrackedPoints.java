package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * The landmarks that a frame was tracked by, at the pixels where it sees them: see {@link
 * Frame#getTrackedPoints}, which fills it again. Belongs to the thread that calls update. An index
 * that is not in 0 .. size()-1 is an IndexOutOfBoundsException.
 */
public final class TrackedPoints {
  // Not of none: JNI need not have an address for that.
  private ByteBuffer structs = Layout.array(1, Layout.TRACKED_POINT_SIZE);
  private int size;
  private long timestampNs;

  TrackedPoints() {}

  /** Makes a larger buffer when there were never as many, and no object otherwise. */
  void fill(long session, long frameTimestampNs) {
    int count = Native.trackedPoints(session, structs);
    if (count > capacity()) {
      structs = Layout.array(Math.max(count, 2 * capacity()), Layout.TRACKED_POINT_SIZE);
      size = 0; // should the session be closed meanwhile
      count = Math.min(Native.trackedPoints(session, structs), capacity());
    }
    size = count;
    timestampNs = frameTimestampNs;
  }

  private int capacity() {
    return structs.capacity() / Layout.TRACKED_POINT_SIZE;
  }

  /** Of the frame that they are of, nanoseconds in the camera's clock. */
  public long getTimestamp() {
    return timestampNs;
  }

  /** How many there are. */
  public int size() {
    return size;
  }

  /** The landmark's id, as in {@link PointCloud#getIds}. */
  public long getId(int index) {
    return structs.getLong(at(index));
  }

  /** Column in the camera's image, pixels; 0 is the centre of the first. */
  public float getX(int index) {
    return structs.getFloat(at(index) + Layout.TRACKED_POINT_U);
  }

  /** Row in the camera's image, pixels; 0 is the centre of the first. */
  public float getY(int index) {
    return structs.getFloat(at(index) + Layout.TRACKED_POINT_V);
  }

  /**
   * How far it is from what the pose says: RMS difference of its patch in grey levels when the frame's
   * tracker is DIRECT, pixels when it is INDIRECT ({@link FrameStats#getTracker}).
   */
  public float getResidual(int index) {
    return structs.getFloat(at(index) + Layout.TRACKED_POINT_RESIDUAL);
  }

  /** Whether it agrees with the pose; on frames of the INDIRECT tracker all do. */
  public boolean isInlier(int index) {
    return structs.getInt(at(index) + Layout.TRACKED_POINT_INLIER) != 0;
  }

  private int at(int index) {
    if (index < 0 || index >= size) {
      throw new IndexOutOfBoundsException("point " + index + " of " + size);
    }
    return index * Layout.TRACKED_POINT_SIZE;
  }
}
