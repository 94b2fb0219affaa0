package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class LifeCycleTest {
  // Enough to make a map of; see SamePosesTest for the poses.
  private static final int ENOUGH = 14;

  private final Sequence sequence = Sequence.walk();

  @Test
  @DisplayName("a session starts without a map, tracks, pauses, resumes, starts over and closes")
  void wholeLife() {
    Session session = new Session(sequence.config());
    Frame frame = sequence.feed(session, 0, 1);
    assertEquals(TrackingState.PAUSED, frame.getCamera().getTrackingState());
    sequence.feed(session, 1, ENOUGH);
    assertEquals(TrackingState.TRACKING, frame.getCamera().getTrackingState());
    assertEquals(TrackingFailureReason.NONE, frame.getCamera().getTrackingFailureReason());

    session.pause();
    session.pause();
    assertEquals(TrackingState.PAUSED, frame.getCamera().getTrackingState());
    assertEquals(TrackingFailureReason.BAD_STATE, frame.getCamera().getTrackingFailureReason());
    assertThrows(SessionPausedException.class, () -> sequence.feed(session, ENOUGH, ENOUGH + 1));
    session.resume();
    sequence.feed(session, ENOUGH, ENOUGH + 1);
    assertEquals(TrackingState.TRACKING, frame.getCamera().getTrackingState());

    session.reset();
    sequence.feed(session, ENOUGH + 1, ENOUGH + 2);
    assertEquals(TrackingState.PAUSED, frame.getCamera().getTrackingState());
    session.close();
    session.close();
    assertEquals(TrackingState.STOPPED, frame.getCamera().getTrackingState());
    assertEquals(TrackingFailureReason.BAD_STATE, frame.getCamera().getTrackingFailureReason());
  }

  @Test
  @DisplayName("update fills the same frame, camera and stats again")
  void sameObjects() {
    try (Session session = new Session(sequence.config())) {
      Frame frame = sequence.feed(session, 0, 1);
      Camera camera = frame.getCamera();
      FrameStats stats = frame.getStats();
      assertEquals(sequence.references.get(0).timestampNs(), frame.getTimestamp());
      assertSame(frame, sequence.feed(session, 1, 2));
      assertSame(camera, frame.getCamera());
      assertSame(stats, frame.getStats());
      assertEquals(sequence.references.get(1).timestampNs(), frame.getTimestamp());
    }
  }

  @Test
  @DisplayName("a frame tells how it was tracked and how long it took")
  void stats() {
    try (Session session = new Session(sequence.config())) {
      Frame frame = sequence.feed(session, 0, 1);
      assertEquals(FrameStats.Tracker.NONE, frame.getStats().getTracker());
      assertEquals(0, frame.getCamera().getConfidence());
      sequence.feed(session, 1, 3);
      assertTrue(frame.getStats().getStartMatches() > 0);
      assertTrue(frame.getStats().getStartParallaxDegrees() > 0);
      assertTrue(frame.getStats().getStartLandmarks() >= 0);
      sequence.feed(session, 3, ENOUGH);
      FrameStats stats = frame.getStats();
      assertTrue(stats.getTracker() != FrameStats.Tracker.NONE);
      assertTrue(stats.getInliers() > 0 && stats.getInliers() <= stats.getVisibleLandmarks());
      float stages = stats.getPyramidMillis() + stats.getPrecomputeMillis() + stats.getAlignMillis()
          + stats.getFeaturesMillis() + stats.getMatchMillis() + stats.getPoseMillis();
      assertTrue(stages > 0 && stages <= stats.getUpdateMillis() + 0.01f);
      assertTrue(stats.getMappingMillis() >= 0 && stats.getRms() > 0);
      assertEquals(0, stats.getReadbackMillis());
      assertEquals(
          stats.getTracker() == FrameStats.Tracker.DIRECT,
          stats.getSwitchReason() == FrameStats.SwitchReason.NONE);
      float confidence = frame.getCamera().getConfidence();
      assertTrue(confidence > 0 && confidence <= 1);
      assertTrue(frame.getMapRevision() > 0 && frame.getMapGeneration() > 0);
      assertFalse(frame.isWorldCorrected());
      assertEquals(0, frame.getCorrectionDistance());
      assertEquals(0, frame.getCorrectionRotation());
      assertEquals(1, frame.getCorrectionScale());
    }
  }

  @Test
  @DisplayName("before the first frame the camera is stopped and at the origin")
  void beforeTheFirstFrame() {
    try (Session session = new Session(sequence.config())) {
      Frame frame = new Frame(session);
      assertEquals(TrackingState.STOPPED, frame.getCamera().getTrackingState());
      assertSame(Pose.IDENTITY, frame.getCamera().getPose());
      assertSame(sequence.camera, frame.getCamera().getImageIntrinsics());
    }
  }

  @Test
  @DisplayName("a session keeps a copy of its config")
  void copiesConfig() {
    Config config = sequence.config();
    try (Session session = new Session(config)) {
      config.setBackend(Config.Backend.GLES);
      sequence.feed(session, 0, 1);
      assertEquals(Config.Backend.CPU, session.getBackend().getBackend());
      assertEquals("", session.getBackend().getVendor());
      assertEquals("", session.getBackend().getRenderer());
      assertEquals("", session.getBackend().getVersion());
    }
  }

  @Test
  @DisplayName("OpenGL ES without a context is refused by the first update, and by no call before it")
  void needsContext() {
    try (Session session = new Session(sequence.config().setBackend(Config.Backend.GLES))) {
      assertThrows(MissingGlContextException.class, () -> sequence.feed(session, 0, 1));
      session.abandonGl();
      session.releaseGl();
    } catch (UnsupportedConfigurationException e) {
      assertTrue(e.getMessage().length() > 0); // a build without OpenGL ES says so when asked
    }
  }
}
