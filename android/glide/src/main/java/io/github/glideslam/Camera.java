package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * The camera at a session's last frame. Like {@link Frame} filled again by every update, and for the
 * thread that calls it.
 */
public final class Camera {
  // GLIDE_STATE_*
  private static final int STATE_TRACKING = 1;

  private final Session session;
  private final ByteBuffer frame;
  private boolean filled;

  Camera(Session session, ByteBuffer frame) {
    this.session = session;
    this.frame = frame;
  }

  void setFilled() {
    filled = true;
  }

  /**
   * TRACKING: the pose is current. PAUSED: there is no map yet, the camera is lost, or the session is
   * paused. STOPPED: there was no frame yet, or the session is closed.
   */
  public TrackingState getTrackingState() {
    if (session.isClosed() || !filled) {
      return TrackingState.STOPPED;
    }
    boolean isTracking = frame.getInt(Layout.FRAME_STATE) == STATE_TRACKING;
    return isTracking && !session.isPaused() ? TrackingState.TRACKING : TrackingState.PAUSED;
  }

  /** Why it is not tracking, and what the user can do about it; NONE while it is. */
  public TrackingFailureReason getTrackingFailureReason() {
    if (session.isClosed() || session.isPaused()) {
      return TrackingFailureReason.BAD_STATE;
    }
    return TrackingFailureReason.of(frame.getInt(Layout.FRAME_REASON));
  }

  /**
   * Camera in world, GL axes: x right, y up, it looks along -z. The last known pose unless tracking;
   * the identity before that. A new object; {@link #getPose(double[], int)} makes none.
   */
  public Pose getPose() {
    return filled ? Pose.read(frame, Layout.FRAME_CAMERA) : Pose.IDENTITY;
  }

  /** Translation x y z and quaternion x y z w to dest[offset .. offset+6]; all 0 before a frame. */
  public void getPose(double[] dest, int offset) {
    Pose.copy(frame, Layout.FRAME_CAMERA, dest, offset);
  }

  /**
   * World to display-oriented camera, column-major for OpenGL, to dest[offset .. offset+15]. Follows
   * {@link Session#setDisplayGeometry}.
   */
  public void getViewMatrix(float[] dest, int offset) {
    Native.viewMatrix(session.handle(), dest, offset);
  }

  /**
   * Projection that fills the display with the centre of the camera's image, column-major for OpenGL,
   * to dest[offset .. offset+15]. {@code 0 < near < far}, scene units.
   */
  public void getProjectionMatrix(float[] dest, int offset, float near, float far) {
    Native.projectionMatrix(session.handle(), near, far, dest, offset);
  }

  /** How sure the pose is, 0 to 1; 0 unless tracking. */
  public float getConfidence() {
    return frame.getFloat(Layout.FRAME_CONFIDENCE);
  }

  /** As given to the session. */
  public CameraIntrinsics getImageIntrinsics() {
    return session.config().getCamera();
  }
}
