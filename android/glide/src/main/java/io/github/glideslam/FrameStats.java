package io.github.glideslam;

import java.nio.ByteBuffer;

/** How a session's last frame was tracked. Filled again by every update; for the thread that calls it. */
public final class FrameStats {
  /** What found the pose. */
  public enum Tracker {
    /** Nothing did. */
    NONE,
    /** Photometric alignment of the whole image. */
    DIRECT,
    /** Matched features. */
    INDIRECT
  }

  private static final Tracker[] TRACKERS = Tracker.values();

  private final ByteBuffer frame;

  FrameStats(ByteBuffer frame) {
    this.frame = frame;
  }

  /** What found the pose. */
  public Tracker getTracker() {
    int tracker = frame.getInt(Layout.FRAME_TRACKER);
    return tracker > 0 && tracker < TRACKERS.length ? TRACKERS[tracker] : Tracker.NONE;
  }

  /** Whether the frame became a keyframe. */
  public boolean isKeyframe() {
    return frame.getInt(Layout.FRAME_KEYFRAME) != 0;
  }

  /** Landmarks that should be in view. */
  public int getVisibleLandmarks() {
    return frame.getInt(Layout.FRAME_VISIBLE);
  }

  /** Landmarks that agree with the pose. */
  public int getInliers() {
    return frame.getInt(Layout.FRAME_INLIERS);
  }

  /** Milliseconds that update took in all. */
  public float getUpdateMillis() {
    return millis(0);
  }

  /** Milliseconds for the image pyramid. */
  public float getPyramidMillis() {
    return millis(1);
  }

  /** Milliseconds for what direct alignment prepares once per keyframe. */
  public float getPrecomputeMillis() {
    return millis(2);
  }

  /** Milliseconds for direct alignment. */
  public float getAlignMillis() {
    return millis(3);
  }

  /** Milliseconds for detecting features. */
  public float getFeaturesMillis() {
    return millis(4);
  }

  /** Milliseconds for matching features. */
  public float getMatchMillis() {
    return millis(5);
  }

  /** Milliseconds for the pose from matches. */
  public float getPoseMillis() {
    return millis(6);
  }

  /** The stages lie in a row. */
  private float millis(int stage) {
    return frame.getFloat(Layout.FRAME_UPDATE_MS + Float.BYTES * stage);
  }
}
