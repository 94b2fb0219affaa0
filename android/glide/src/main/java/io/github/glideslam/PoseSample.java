package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * Where the camera was, or will be, at a time: see {@link Session#locate}. May be filled again, by one
 * thread at a time.
 */
public final class PoseSample {
  // GLIDE_LOCATION_*
  private static final int VALID = 1;
  private static final int TRACKED = 2;

  final ByteBuffer struct = Layout.struct(Layout.LOCATION_SIZE);

  /** Neither valid nor tracked until a session fills it. */
  public PoseSample() {}

  /** Nanoseconds in the camera's clock. */
  public long getTimestamp() {
    return struct.getLong(Layout.LOCATION_TIME);
  }

  /** Whether there is a pose at all. */
  public boolean isValid() {
    return (struct.getInt(Layout.LOCATION_FLAGS) & VALID) != 0;
  }

  /** Whether it rests on tracked frames around that time; else it is the last known one. */
  public boolean isTracked() {
    return (struct.getInt(Layout.LOCATION_FLAGS) & TRACKED) != 0;
  }

  /** Camera in world, GL axes; the identity when not valid. */
  public Pose getPose() {
    return isValid() ? Pose.read(struct, Layout.LOCATION_CAMERA) : Pose.IDENTITY;
  }

  /** Translation x y z and quaternion x y z w to dest[offset .. offset+6]; allocates nothing. */
  public void getPose(double[] dest, int offset) {
    Pose.copy(struct, Layout.LOCATION_CAMERA, dest, offset);
  }
}
