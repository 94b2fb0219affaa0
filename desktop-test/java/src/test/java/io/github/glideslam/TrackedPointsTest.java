package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** What a frame was tracked by. */
class TrackedPointsTest {
  // A direct frame is compared with its reference once more: who is on the border may change sides.
  private static final int NEARLY = 3;

  private final Sequence sequence = Sequence.walk();

  private Session session(Config.ReportPoints report) {
    return new Session(sequence.config().setTrackedPoints(report));
  }

  private interface Check {
    void run(Frame frame, TrackedPoints points);
  }

  private void walk(Session session, Check check) {
    for (int i = 0; i < sequence.size(); ++i) {
      Frame frame = sequence.feed(session, i, i + 1);
      check.run(frame, frame.getTrackedPoints());
    }
  }

  private static int inliersOf(TrackedPoints points) {
    int inliers = 0;
    for (int i = 0; i < points.size(); ++i) {
      inliers += points.isInlier(i) ? 1 : 0;
    }
    return inliers;
  }

  private static Set<Long> idsOf(MapSnapshot map) {
    Set<Long> ids = new HashSet<>();
    try (PointCloud cloud = map.getPoints()) {
      for (int i = 0; i < cloud.size(); ++i) {
        ids.add(cloud.getIds().get(i));
      }
    }
    return ids;
  }

  @Test
  @DisplayName("they lie in the image, with residuals, as many inliers as the frame's statistics tell")
  void points() {
    int[] tracked = new int[FrameStats.Tracker.values().length];
    try (Session session = session(Config.ReportPoints.ON)) {
      walk(session, (frame, points) -> {
        assertSame(frame.getTrackedPoints(), points);
        if (points.size() == 0) {
          return;
        }
        ++tracked[frame.getStats().getTracker().ordinal()];
        assertEquals(TrackingState.TRACKING, frame.getCamera().getTrackingState());
        assertEquals(frame.getTimestamp(), points.getTimestamp());
        assertEquals(frame.getStats().getInliers(), inliersOf(points), NEARLY);
        for (int i = 0; i < points.size(); ++i) {
          assertTrue(points.getX(i) > 0 && points.getX(i) < sequence.camera.width(), "x");
          assertTrue(points.getY(i) > 0 && points.getY(i) < sequence.camera.height(), "y");
          assertTrue(points.getResidual(i) >= 0, "residual");
        }
      });
    }
    assertTrue(tracked[FrameStats.Tracker.DIRECT.ordinal()] > sequence.size() / 2);
    assertTrue(tracked[FrameStats.Tracker.INDIRECT.ordinal()] > 1);
  }

  @Test
  @DisplayName("they are landmarks of the map, each once")
  void ids() {
    try (Session session = session(Config.ReportPoints.ON)) {
      Set<Long> known = new HashSet<>(); // a landmark may be culled after the frame that saw it
      int[] seen = {0};
      walk(session, (frame, points) -> {
        Set<Long> ids = new HashSet<>();
        for (int i = 0; i < points.size(); ++i) {
          ids.add(points.getId(i));
        }
        assertEquals(points.size(), ids.size());
        assertTrue(known.containsAll(ids));
        seen[0] += ids.size();
        try (MapSnapshot map = session.acquireMap()) {
          known.addAll(idsOf(map));
        }
      });
      assertTrue(seen[0] > 40 * sequence.size() / 2, seen[0] + " points");
    }
  }

  @Test
  @DisplayName("every tracked frame has them but the one that starts the map")
  void notAtTheStart() {
    int[] without = {0};
    int[] with = {0};
    try (Session session = session(Config.ReportPoints.ON)) {
      walk(session, (frame, points) -> {
        if (frame.getCamera().getTrackingState() == TrackingState.TRACKING) {
          ++(points.size() == 0 ? without : with)[0];
          assertTrue(points.size() > 0 || with[0] == 0);
        }
      });
    }
    assertEquals(1, without[0]);
    assertTrue(with[0] > sequence.size() / 2);
  }

  @Test
  @DisplayName("there are none unless asked for")
  void off() {
    for (Config config :
        new Config[] {
          sequence.config(), sequence.config().setTrackedPoints(Config.ReportPoints.OFF)
        }) {
      try (Session session = new Session(config)) {
        walk(session, (frame, points) -> assertEquals(0, points.size()));
      }
    }
  }

  @Test
  @DisplayName("there are those of indirect frames when only these are asked for")
  void indirect() {
    int[] filled = {0};
    try (Session session = session(Config.ReportPoints.INDIRECT)) {
      walk(session, (frame, points) -> {
        boolean isDirect = frame.getStats().getTracker() == FrameStats.Tracker.DIRECT;
        assertFalse(isDirect && points.size() > 0);
        filled[0] += points.size() > 0 ? 1 : 0;
      });
    }
    assertTrue(filled[0] > 1);
  }

  @Test
  @DisplayName("a reset leaves none, and a closed session those that were read")
  void resetAndClose() {
    Session session = session(Config.ReportPoints.ON);
    Frame frame = sequence.feed(session, 0, TrackedTest.FED);
    TrackedPoints points = frame.getTrackedPoints();
    int size = points.size();
    assertTrue(size > 40, size + " points");
    float x = points.getX(size - 1);
    session.close();
    assertThrows(SessionClosedException.class, frame::getTrackedPoints);
    assertEquals(size, points.size());
    assertEquals(x, points.getX(size - 1));

    try (Session other = session(Config.ReportPoints.ON)) {
      Frame last = sequence.feed(other, 0, TrackedTest.FED);
      assertEquals(size, last.getTrackedPoints().size());
      other.reset();
      assertEquals(0, last.getTrackedPoints().size());
    }
  }

  @Test
  @DisplayName("an index must be one of a point")
  void indices() {
    try (Session session = session(Config.ReportPoints.ON)) {
      TrackedPoints points = sequence.feed(session, 0, TrackedTest.FED).getTrackedPoints();
      for (int index : new int[] {-1, points.size(), Integer.MIN_VALUE, Integer.MAX_VALUE}) {
        assertThrows(IndexOutOfBoundsException.class, () -> points.getId(index));
        assertThrows(IndexOutOfBoundsException.class, () -> points.getX(index));
        assertThrows(IndexOutOfBoundsException.class, () -> points.getY(index));
        assertThrows(IndexOutOfBoundsException.class, () -> points.getResidual(index));
        assertThrows(IndexOutOfBoundsException.class, () -> points.isInlier(index));
      }
    }
    assertThrows(InvalidArgumentException.class, () -> sequence.config().setTrackedPoints(null));
  }
}
