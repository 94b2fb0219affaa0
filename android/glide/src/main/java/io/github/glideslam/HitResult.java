package io.github.glideslam;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Where a ray meets the map; immutable. */
public final class HitResult {
  // The plane and the nearest landmark: more than the library gives today.
  private static final int MOST_HITS = 8;

  private final Session session;
  private final Pose pose;
  private final float distance;
  private final int pointCount;

  private HitResult(Session session, ByteBuffer hits, int at) {
    this.session = session;
    pose = Pose.read(hits, at);
    distance = hits.getFloat(at + Layout.HIT_DISTANCE);
    pointCount = hits.getInt(at + Layout.HIT_POINTS);
  }

  static List<HitResult> test(Session session, float x, float y) {
    ByteBuffer hits = Layout.array(MOST_HITS, Layout.HIT_SIZE);
    int count = Math.min(MOST_HITS, Native.hitTest(session.handle(), x, y, hits));
    List<HitResult> results = new ArrayList<>(count);
    for (int i = 0; i < count; ++i) {
      results.add(new HitResult(session, hits, i * Layout.HIT_SIZE));
    }
    return Collections.unmodifiableList(results);
  }

  /** At the hit, in the world; the y axis is the surface's normal. */
  public Pose getHitPose() {
    return pose;
  }

  /** From the camera, scene units. */
  public float getDistance() {
    return distance;
  }

  /** Landmarks that the surface rests on; 1: a single landmark, whose normal points to the camera. */
  public int getPointCount() {
    return pointCount;
  }

  /**
   * An anchor at the hit, before the next update: the hit is of the last frame's map. As {@link
   * Session#createAnchor}.
   */
  public Anchor createAnchor() {
    return session.createAnchor(pose);
  }
}
