package io.github.glideslam;

import java.nio.ByteBuffer;
import java.util.Collection;
import java.util.List;

/**
 * What the last {@link Session#update} found. There is one object per session, which every update
 * fills again: keep values, not the frame. Belongs to the thread that calls update.
 */
public final class Frame {
  final ByteBuffer struct = Layout.struct(Layout.FRAME_SIZE);
  private final Session session;
  private final Camera camera;
  private final FrameStats stats = new FrameStats(struct);
  private final TrackedPoints trackedPoints = new TrackedPoints();

  Frame(Session session) {
    this.session = session;
    camera = new Camera(session, struct);
  }

  void setFilled() {
    camera.setFilled();
  }

  /** Nanoseconds in the camera's clock; 0 before the first frame. */
  public long getTimestamp() {
    return struct.getLong(Layout.FRAME_TIME);
  }

  /** The camera at this frame; the same object each time. */
  public Camera getCamera() {
    return camera;
  }

  /** How the frame was tracked, and how long it took; the same object each time. */
  public FrameStats getStats() {
    return stats;
  }

  /** Grows when landmarks or keyframes have changed. */
  public long getMapRevision() {
    return struct.getLong(Layout.FRAME_REVISION);
  }

  /**
   * Grows when a new map is begun: after {@link Session#reset}, {@link Session#loadMap}, or a start
   * that was soon lost. A new map is a new world: scale and gravity are arbitrary again, and poses of
   * different generations have nothing to do with each other.
   */
  public long getMapGeneration() {
    return struct.getLong(Layout.FRAME_GENERATION);
  }

  /**
   * Whether the map was corrected before this frame: the camera has moved in the world without
   * moving in the room. What hangs on anchors follows.
   */
  public boolean isWorldCorrected() {
    return struct.getInt(Layout.FRAME_CORRECTED) != 0;
  }

  /** How far the correction moved the camera, scene units; 0 without a correction. */
  public float getCorrectionDistance() {
    return struct.getFloat(Layout.FRAME_CORRECTION_DISTANCE);
  }

  /** How far the correction turned the camera, radians; 0 without a correction. */
  public float getCorrectionRotation() {
    return struct.getFloat(Layout.FRAME_CORRECTION_ROTATION);
  }

  /** By how much the correction scaled the world; 1 without a correction, 0 before the first frame. */
  public float getCorrectionScale() {
    return struct.getFloat(Layout.FRAME_CORRECTION_SCALE);
  }

  /** Landmarks in this frame's view; close it. Empty unless the camera is tracking. */
  public PointCloud acquirePointCloud() {
    return PointCloud.ofSession(session, getTimestamp());
  }

  /**
   * The landmarks that this frame was tracked by, at the pixels where it sees them; the same object
   * each time, filled again by each call. Empty unless the camera is tracking and {@link
   * Config#setTrackedPoints} asked for them. A frame that starts a map is tracked by none.
   *
   * @throws SessionClosedException when the session is closed; the points stay as they were
   */
  public TrackedPoints getTrackedPoints() {
    trackedPoints.fill(session.handle(), getTimestamp());
    return trackedPoints;
  }

  /**
   * What the ray through a pixel of the camera's image meets, nearest first: landmarks near it, and
   * the plane through those. Empty when there is nothing. Pixel (0, 0) is the centre of the first.
   */
  public List<HitResult> hitTest(float x, float y) {
    return HitResult.test(session, x, y);
  }

  /**
   * Anchors whose pose or state has changed since the last frame for which this was called: what a
   * correction of the map, a metric scale or a gravity hint moved. The collection is used again.
   */
  public Collection<Anchor> getUpdatedAnchors() {
    return session.updatedAnchors();
  }
}
