package io.github.glideslam;

/** Whether a pose is current. */
public enum TrackingState {
  /** The pose is current. */
  TRACKING,
  /** The last known pose; tracking goes on by itself: see {@link TrackingFailureReason}. */
  PAUSED,
  /** There is nothing to track, and will not be: no frame yet, a closed session, an anchor whose map is gone. */
  STOPPED
}
