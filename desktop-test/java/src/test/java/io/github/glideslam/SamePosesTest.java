package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Java's poses are the C++ API's. */
class SamePosesTest {
  private static final double TOLERANCE = 1e-9;

  @Test
  @DisplayName("a rendered sequence has the same poses in Java and in C++")
  void rendered() {
    compare(Sequence.walk());
  }

  @Test
  @DisplayName("a real sequence has the same poses in Java and in C++")
  void real() {
    assumeTrue(Sequence.exists("desk"), "shared/data/desk_fisheye_400 is not there");
    compare(Sequence.open("desk"));
  }

  private static void compare(Sequence sequence) {
    int tracked = 0;
    try (Session session = new Session(sequence.config())) {
      for (int i = 0; i < sequence.size(); ++i) {
        Frame frame = sequence.feed(session, i, i + 1);
        Sequence.Reference reference = sequence.references.get(i);
        boolean isTracked = frame.getCamera().getTrackingState() == TrackingState.TRACKING;
        assertEquals(reference.isTracked(), isTracked, "frame " + i);
        if (isTracked) {
          assertSamePose(reference.pose(), frame, "frame " + i);
          ++tracked;
        }
      }
    }
    assertTrue(tracked > sequence.size() / 4, tracked + " frames tracked");
  }

  private static void assertSamePose(double[] expected, Frame frame, String what) {
    double[] pose = new double[7];
    frame.getCamera().getPose(pose, 0);
    // A quaternion and its negative are one rotation.
    double dot = 0;
    for (int i = 3; i < 7; ++i) {
      dot += expected[i] * pose[i];
    }
    for (int i = 0; i < 7; ++i) {
      double sign = i >= 3 && dot < 0 ? -1 : 1;
      assertEquals(expected[i], sign * pose[i], TOLERANCE, what);
    }
    double[] object = new double[7];
    frame.getCamera().getPose().getExact(object, 0);
    for (int i = 0; i < 7; ++i) {
      assertEquals(pose[i], object[i], TOLERANCE, what);
    }
  }
}
