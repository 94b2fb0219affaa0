package io.github.glideslam.sample;

import io.github.glideslam.Camera;
import io.github.glideslam.Frame;
import io.github.glideslam.TrackingFailureReason;
import io.github.glideslam.TrackingState;
import java.util.Locale;

/** What to tell the user about a frame. */
final class StateText {
  static String of(Frame frame) {
    Camera camera = frame.getCamera();
    if (camera.getTrackingState() != TrackingState.TRACKING) {
      return advice(camera.getTrackingFailureReason());
    }
    return String.format(
        Locale.ROOT, "%s, %d landmarks, %.1f ms: tap to place a cube",
        frame.getStats().getTracker(), frame.getStats().getInliers(),
        frame.getStats().getUpdateMillis());
  }

  private static String advice(TrackingFailureReason reason) {
    switch (reason) {
      case INSUFFICIENT_FEATURES:
        return "Point the camera at something with detail";
      case EXCESSIVE_MOTION:
        return "Move more slowly";
      case INSUFFICIENT_PARALLAX:
        return "Move the phone sideways";
      case AMBIGUOUS:
        return "Keep moving";
      case RELOCALIZING:
        return "Lost: return to where the camera has been";
      default:
        return "Looking around";
    }
  }

  private StateText() {}
}
