package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class AnchorTest extends TrackedTest {
  private final Pose place = new Pose(new float[] {0.1f, 0.2f, -2}, new float[] {0, 0, 0, 1});

  @Test
  @DisplayName("an anchor is where it was put, until it is detached")
  void life() {
    Anchor anchor = session.createAnchor(place);
    assertArrayEquals(place.getTranslation(), anchor.getPose().getTranslation(), 1e-6f);
    double[] pose = new double[8];
    anchor.getPose(pose, 1);
    assertEquals(0.1, pose[1], 1e-6);
    assertEquals(1, Math.abs(pose[7]), 1e-6);
    assertEquals(TrackingState.TRACKING, anchor.getTrackingState());
    assertEquals(List.of(anchor), session.getAllAnchors());
    session.pause();
    assertEquals(TrackingState.PAUSED, anchor.getTrackingState());
    anchor.detach();
    anchor.detach();
    assertEquals(TrackingState.STOPPED, anchor.getTrackingState());
    assertArrayEquals(place.getTranslation(), anchor.getPose().getTranslation(), 1e-6f);
    assertTrue(session.getAllAnchors().isEmpty());
  }

  @Test
  @DisplayName("what moves anchors is told once, with the frame after it")
  void updates() {
    Anchor anchor = session.createAnchor(place);
    sequence.feed(session, FED, FED + 1).getUpdatedAnchors();
    session.setMetricScale(2);
    sequence.feed(session, FED + 1, FED + 2);
    assertEquals(List.of(anchor), List.copyOf(frame.getUpdatedAnchors()));
    assertEquals(List.of(anchor), List.copyOf(frame.getUpdatedAnchors()), "the same frame");
    assertEquals(0.2f, anchor.getPose().tx(), 0.01f);
  }

  @Test
  @DisplayName("with mapping on a thread of its own, too, the first frame that is tracked can have anchors")
  void firstTrackedFrame() {
    try (Session live = new Session(sequence.config().setDeterministic(false))) {
      Camera camera = sequence.feed(live, 0, 1).getCamera();
      for (int i = 1; camera.getTrackingState() != TrackingState.TRACKING; ++i) {
        live.waitForMapping();
        sequence.feed(live, i, i + 1);
      }
      assertEquals(TrackingState.TRACKING, live.createAnchor(place).getTrackingState());
    }
  }

  @Test
  @DisplayName("an anchor stops when its map is dropped, and is told as updated")
  void lostMap() {
    Anchor anchor = session.createAnchor(place);
    sequence.feed(session, FED, FED + 1).getUpdatedAnchors();
    session.reset();
    assertEquals(TrackingState.STOPPED, anchor.getTrackingState());
    sequence.feed(session, FED + 1, FED + 2);
    assertSame(anchor, frame.getUpdatedAnchors().iterator().next());
  }

  @Test
  @DisplayName("an anchor of a closed session stops, and tells no pose")
  void closedSession() {
    Anchor anchor = session.createAnchor(place);
    session.close();
    assertEquals(TrackingState.STOPPED, anchor.getTrackingState());
    assertThrows(SessionClosedException.class, anchor::getPose);
    anchor.detach();
  }

  @Test
  @DisplayName("updated anchors cannot be changed from outside")
  void readOnly() {
    assertThrows(UnsupportedOperationException.class, () -> frame.getUpdatedAnchors().add(null));
    assertThrows(InvalidArgumentException.class, () -> session.createAnchor(null));
  }
}
