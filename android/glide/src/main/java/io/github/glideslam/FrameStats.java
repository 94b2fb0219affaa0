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

  /** Why the direct tracker did not make the pose. */
  public enum SwitchReason {
    /** It did. */
    NONE,
    /** There is no keyframe to align to yet. */
    NO_REFERENCE,
    /** The alignment did not converge. */
    SOLVE_FAILED,
    /** Too few of the keyframe's points are in view. */
    TOO_FEW_VISIBLE,
    /** The images differ too much after alignment. */
    PHOTOMETRIC_ERROR,
    /** The camera is too far from the keyframe. */
    BASELINE,
    /** The camera has turned too far from the keyframe. */
    ROTATION,
    /** It had its turn: features are due now and then. */
    MAX_DIRECT_FRAMES,
    /** The config wants features only. */
    DISABLED
  }

  private static final SwitchReason[] REASONS = SwitchReason.values();
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

  /** Milliseconds for mapping, with {@link Config#setDeterministic}; not part of update's. */
  public float getMappingMillis() {
    return millis(7);
  }

  /** Milliseconds for bringing a texture's pixels to the CPU. */
  public float getReadbackMillis() {
    return millis(8);
  }

  /** Error of the pose: grey levels of a patch (DIRECT), or pixels (INDIRECT). */
  public float getRms() {
    return frame.getFloat(Layout.FRAME_RMS);
  }

  /** Why the direct tracker did not make the pose; NONE when it did. */
  public SwitchReason getSwitchReason() {
    int reason = frame.getInt(Layout.FRAME_SWITCH_REASON);
    return reason >= 0 && reason < REASONS.length ? REASONS[reason] : SwitchReason.DISABLED;
  }

  /** Features matched with the first view, while there is no map. */
  public int getStartMatches() {
    return frame.getInt(Layout.FRAME_START_MATCHES);
  }

  /** Median parallax of these, degrees. */
  public float getStartParallaxDegrees() {
    return frame.getFloat(Layout.FRAME_START_PARALLAX);
  }

  /** Landmarks that the best start would have, while there is no map. */
  public int getStartLandmarks() {
    return frame.getInt(Layout.FRAME_START_LANDMARKS);
  }

  /** The stages lie in a row. */
  private float millis(int stage) {
    return frame.getFloat(Layout.FRAME_UPDATE_MS + Float.BYTES * stage);
  }
}
