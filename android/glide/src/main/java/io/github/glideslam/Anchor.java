package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * A place in the scene: when the map is corrected, the pose follows. Any thread.
 *
 * <p>{@link Frame#getUpdatedAnchors} tells which ones have moved.
 */
public final class Anchor {
  private final Session session;
  private final long id;
  private final ByteBuffer struct = Layout.struct(Layout.ANCHOR_SIZE);
  private final ByteBuffer reported = Layout.struct(Layout.ANCHOR_SIZE);
  private boolean detached;

  Anchor(Session session, long id) {
    this.session = session;
    this.id = id;
    refresh();
    report();
  }

  /** In the world, now; the last known pose of a detached anchor. A new object. */
  public synchronized Pose getPose() {
    refresh();
    return Pose.read(struct, Layout.ANCHOR_POSE);
  }

  /** The same to dest[offset .. offset+6]: translation x y z, quaternion x y z w. Allocates nothing. */
  public synchronized void getPose(double[] dest, int offset) {
    refresh();
    Pose.copy(struct, Layout.ANCHOR_POSE, dest, offset);
  }

  /**
   * TRACKING while the map that it belongs to is there, PAUSED while the session is paused; STOPPED,
   * for good, when the map was replaced, the anchor detached or the session closed.
   */
  public synchronized TrackingState getTrackingState() {
    if (detached || session.isClosed()) {
      return TrackingState.STOPPED;
    }
    refresh();
    if (struct.getInt(Layout.ANCHOR_TRACKING) == 0) {
      return TrackingState.STOPPED;
    }
    return session.isPaused() ? TrackingState.PAUSED : TrackingState.TRACKING;
  }

  /** Forgets the anchor; more than once is fine. */
  public void detach() {
    synchronized (this) {
      if (detached) {
        return;
      }
      detached = true;
    }
    session.forget(this);
  }

  long id() {
    return id;
  }

  /** Whether its pose or state is another one than when this was asked last. */
  synchronized boolean takeUpdate() {
    refresh();
    // Not the revision alone: a metric scale moves anchors without correcting the map.
    boolean isUpdated = !struct.equals(reported);
    report();
    return isUpdated;
  }

  private void report() {
    for (int at = 0; at < Layout.ANCHOR_SIZE; at += Long.BYTES) {
      reported.putLong(at, struct.getLong(at));
    }
  }

  private void refresh() {
    if (!detached) {
      Native.anchor(session.handle(), id, struct);
    }
  }
}
