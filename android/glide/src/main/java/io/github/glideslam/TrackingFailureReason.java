package io.github.glideslam;

/** Why the camera is not {@link TrackingState#TRACKING}: the most useful thing to tell the user. */
public enum TrackingFailureReason {
  /** It is tracking, or the map is being made, or nothing is known yet. */
  NONE,
  /** Dark, blurred or blank: point the camera at something with detail. */
  INSUFFICIENT_FEATURES,
  /** Move more slowly. */
  EXCESSIVE_MOTION,
  /** There is no map yet: move the camera sideways. */
  INSUFFICIENT_PARALLAX,
  /** Two explanations fit what was seen: keep moving. */
  AMBIGUOUS,
  /** Lost: return to where the camera has been. */
  RELOCALIZING,
  /** The session is paused or closed. */
  BAD_STATE;

  private static final TrackingFailureReason[] VALUES = values();

  /** Of GLIDE_REASON_*. */
  static TrackingFailureReason of(int reason) {
    return reason >= 0 && reason < BAD_STATE.ordinal() ? VALUES[reason] : BAD_STATE;
  }
}
