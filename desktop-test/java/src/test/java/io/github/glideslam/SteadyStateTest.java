package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Frame after frame. */
class SteadyStateTest {
  private static final int WARM_UP = 20;

  private final Sequence sequence = Sequence.walk();

  /** What an app does per frame, without what it need not. */
  private static final class FrameLoop {
    private final Session session;
    private final CameraInput.Luma input;
    private final int width;
    private final float[] view = new float[16];
    private final float[] projection = new float[16];
    private final double[] pose = new double[7];
    private final PoseSample sample = new PoseSample();
    private int tracked;
    private int inliers;

    FrameLoop(Session session, Sequence sequence) {
      this.session = session;
      input = sequence.input();
      width = sequence.camera.width();
    }

    void run(ByteBuffer image, long timestampNs) {
      Frame frame = session.update(input.set(image, width, 1, timestampNs));
      Camera camera = frame.getCamera();
      if (camera.getTrackingState() == TrackingState.TRACKING
          && camera.getTrackingFailureReason() == TrackingFailureReason.NONE
          && frame.getStats().getTracker() != FrameStats.Tracker.NONE) {
        ++tracked;
      }
      camera.getPose(pose, 0);
      camera.getViewMatrix(view, 0);
      camera.getProjectionMatrix(projection, 0, 0.1f, 100);
      session.pushImu(timestampNs, 0, 9.8f, 0, 0, 0, 0);
      session.locate(timestampNs, sample).getPose(pose, 0);
      TrackedPoints points = frame.getTrackedPoints();
      for (int i = 0; i < points.size(); ++i) {
        inliers += points.isInlier(i) && points.getX(i) > 0 && points.getY(i) > 0 ? 1 : 0;
      }
      for (Anchor anchor : emptyAsList(frame)) {
        anchor.getPose(pose, 0);
      }
    }

    /** An iterator of an empty collection is an object, too. */
    private static Iterable<Anchor> emptyAsList(Frame frame) {
      return frame.getUpdatedAnchors().isEmpty()
          ? java.util.Collections.emptyList()
          : frame.getUpdatedAnchors();
    }
  }

  @Test
  @DisplayName("a tracked frame makes no Java object")
  void allocatesNothing() {
    ByteBuffer[] images = new ByteBuffer[sequence.size()];
    long[] times = new long[sequence.size()];
    for (int i = 0; i < images.length; ++i) {
      images[i] = sequence.image(i);
      times[i] = sequence.references.get(i).timestampNs();
    }
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long self = Thread.currentThread().getId();
    Config config = sequence.config().setTrackedPoints(Config.ReportPoints.ON);
    try (Session session = new Session(config)) {
      FrameLoop loop = new FrameLoop(session, sequence);
      for (int i = 0; i < WARM_UP; ++i) {
        loop.run(images[i], times[i]);
        if (i == WARM_UP / 2) {
          session.createAnchor(Pose.IDENTITY);
        }
      }
      loop.tracked = 0;
      loop.inliers = 0;
      threads.getThreadAllocatedBytes(self);
      long before = threads.getThreadAllocatedBytes(self);
      for (int i = WARM_UP; i < images.length; ++i) {
        loop.run(images[i], times[i]);
      }
      long after = threads.getThreadAllocatedBytes(self);
      assertEquals(0, after - before, "bytes");
      assertEquals(images.length - WARM_UP, loop.tracked);
      assertTrue(loop.inliers > 40 * loop.tracked, loop.inliers + " tracked points");
    }
  }

  @Test
  @DisplayName("the counter of the test above does count")
  void counts() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long self = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(self);
    Pose pose = Pose.makeTranslation(1, 2, 3).inverse();
    assertTrue(threads.getThreadAllocatedBytes(self) - before > 0, pose.toString());
  }

  @Test
  @DisplayName("a garbage collector that never rests changes no pose")
  void garbage() throws InterruptedException {
    AtomicBoolean isDone = new AtomicBoolean();
    Thread litter = new Thread(() -> {
      while (!isDone.get()) {
        ByteBuffer.allocateDirect(1 << 16).put(0, new byte[1 << 16]);
        System.gc();
      }
    });
    litter.start();
    double[] pose = new double[7];
    try (Session session = new Session(sequence.config())) {
      sequence.feed(session, 0, sequence.size()).getCamera().getPose(pose, 0);
    } finally {
      isDone.set(true);
      litter.join();
    }
    double[] expected = sequence.references.get(sequence.size() - 1).pose();
    for (int i = 0; i < 3; ++i) {
      assertEquals(expected[i], pose[i], 1e-9);
    }
  }
}
