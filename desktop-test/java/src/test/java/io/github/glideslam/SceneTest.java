package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Matrices, points, hits, times, and what the world is told. */
class SceneTest extends TrackedTest {
  @Test
  @DisplayName("the view matrix is the camera's pose, inverted, written from the offset on")
  void view() {
    float[] view = new float[20];
    float[] expected = new float[20];
    Arrays.fill(view, 7);
    Arrays.fill(expected, 7);
    frame.getCamera().getViewMatrix(view, 3);
    frame.getCamera().getPose().inverse().toMatrix(expected, 3);
    assertArrayEquals(expected, view, 1e-6f);
  }

  @Test
  @DisplayName("the projection takes the camera's focal length to the borders of the image")
  void projection() {
    float[] projection = new float[16];
    frame.getCamera().getProjectionMatrix(projection, 0, 0.1f, 100);
    float[] focal = sequence.camera.getFocalLength();
    int[] size = sequence.camera.getImageDimensions();
    assertEquals(2 * focal[0] / size[0], projection[0], 1e-4f);
    assertEquals(2 * focal[1] / size[1], projection[5], 1e-4f);
    assertEquals(-1, projection[11]);
    assertThrows(
        InvalidArgumentException.class,
        () -> frame.getCamera().getProjectionMatrix(projection, 0, 1, 1));
  }

  @Test
  @DisplayName("a display that is turned turns the view and swaps the projection's axes")
  void display() {
    float[] upright = new float[16];
    float[] turned = new float[16];
    frame.getCamera().getProjectionMatrix(upright, 0, 0.1f, 100);
    session.setDisplayGeometry(90, 240, 320);
    frame.getCamera().getProjectionMatrix(turned, 0, 0.1f, 100);
    assertEquals(upright[0], turned[5], 1e-4f);
    assertEquals(upright[5], turned[0], 1e-4f);
    assertThrows(
        InvalidArgumentException.class, () -> session.setDisplayGeometry(45, 240, 320));
    assertThrows(InvalidArgumentException.class, () -> session.setDisplayGeometry(0, -1, 320));
  }

  @Test
  @DisplayName("points lie in front of the camera, with ids and confidences, until closed")
  void points() {
    PointCloud cloud = frame.acquirePointCloud();
    int size = cloud.size();
    assertTrue(size > 20, size + " points");
    assertEquals(size * PointCloud.FLOATS_PER_POINT, cloud.getPoints().remaining());
    assertEquals(size, cloud.getIds().remaining());
    assertTrue(cloud.getPoints().isDirect() && cloud.getIds().isDirect());
    assertEquals(frame.getTimestamp(), cloud.getTimestamp());
    Pose world = frame.getCamera().getPose().inverse();
    for (int i = 0; i < size; ++i) {
      float[] point = new float[4];
      cloud.getPoints().position(4 * i).get(point);
      assertTrue(world.transformPoint(Arrays.copyOf(point, 3))[2] < 0, "in front");
      assertTrue(point[3] > 0 && point[3] <= 1, "confidence");
    }
    assertEquals(size, Arrays.stream(idsOf(cloud)).distinct().count());
    cloud.close();
    cloud.close();
    assertThrows(SessionClosedException.class, cloud::getPoints);
    assertThrows(SessionClosedException.class, cloud::size);
  }

  private static long[] idsOf(PointCloud cloud) {
    long[] ids = new long[cloud.size()];
    cloud.getIds().get(ids);
    return ids;
  }

  @Test
  @DisplayName("the ray through a pixel meets the wall in front of it")
  void hits() {
    List<HitResult> hits = frame.hitTest(160, 120);
    assertFalse(hits.isEmpty());
    float before = 0;
    for (HitResult hit : hits) {
      assertTrue(hit.getDistance() >= before && hit.getPointCount() >= 1);
      before = hit.getDistance();
      float[] hitInCamera =
          frame.getCamera().getPose().inverse().transformPoint(hit.getHitPose().getTranslation());
      assertTrue(hitInCamera[2] < 0);
    }
    assertTrue(frame.hitTest(-5000, 0).isEmpty());
    assertThrows(UnsupportedOperationException.class, () -> hits.remove(0));
    assertEquals(
        TrackingState.TRACKING, hits.get(0).createAnchor().getTrackingState());
  }

  @Test
  @DisplayName("a metric scale scales poses and points at once")
  void metricScale() {
    float before = sequence.feed(session, FED, FED + 1).getCamera().getPose().tx();
    session.setMetricScale(3);
    // The same place once more would not be a new frame: the last pose, asked for by time.
    Pose scaled = session.locate(frame.getTimestamp()).getPose();
    assertEquals(3 * before, scaled.tx(), Math.abs(before) * 1e-5);
    assertThrows(InvalidArgumentException.class, () -> session.setMetricScale(-1));
    assertThrows(InvalidArgumentException.class, () -> session.setMetricScale(Float.NaN));
  }

  @Test
  @DisplayName("a gravity hint turns the world until its y axis points up")
  void gravity() {
    session.setGravityHint(1, -2, 0.5f);
    Pose camera = session.locate(frame.getTimestamp()).getPose();
    float length = (float) Math.sqrt(5.25);
    float[] down = camera.rotateVector(new float[] {1, -2, 0.5f});
    assertArrayEquals(new float[] {0, -length, 0}, down, 1e-5f);
    assertThrows(InvalidArgumentException.class, () -> session.setGravityHint(0, 0, 0));
  }

  @Test
  @DisplayName("scale and gravity need a tracked frame")
  void needTracking() {
    try (Session fresh = new Session(sequence.config())) {
      assertThrows(NotTrackingException.class, () -> fresh.setMetricScale(2));
      assertThrows(NotTrackingException.class, () -> fresh.setGravityHint(0, -1, 0));
      assertThrows(NotTrackingException.class, () -> fresh.createAnchor(Pose.IDENTITY));
    }
  }

  @Test
  @DisplayName("the camera is located between frames, a little ahead, and nowhere else")
  void locate() {
    long now = frame.getTimestamp();
    long before = sequence.references.get(FED - 2).timestampNs();
    PoseSample sample = new PoseSample();
    assertFalse(sample.isValid());
    assertEquals(sample, session.locate((before + now) / 2, sample));
    assertTrue(sample.isValid() && sample.isTracked());
    assertEquals((before + now) / 2, sample.getTimestamp());
    double[] pose = new double[7];
    sample.getPose(pose, 0);
    double[] first = sequence.references.get(FED - 2).pose();
    double[] last = sequence.references.get(FED - 1).pose();
    assertEquals((first[0] + last[0]) / 2, pose[0], 1e-3);
    assertTrue(session.locate(now + 50_000_000).isValid());
    PoseSample far = session.locate(now + 10_000_000_000L);
    assertFalse(far.isTracked());
    assertThrows(InvalidArgumentException.class, () -> session.locate(now, null));
  }

  @Test
  @DisplayName("IMU samples are taken in the order of time only")
  void imu() {
    session.pushImu(1, 0, 9.8f, 0, 0, 0, 0);
    session.pushImu(2, 0, 9.8f, 0, 0, 0, 0);
    assertThrows(
        TimestampOrderException.class, () -> session.pushImu(2, 0, 9.8f, 0, 0, 0, 0));
  }
}
