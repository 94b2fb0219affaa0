package io.github.glideslam.android;

import io.github.glideslam.CameraIntrinsics;

/** Intrinsics, and what they rest on; immutable. */
public final class CameraCalibration {
  private final CameraIntrinsics intrinsics;
  private final boolean estimated;

  CameraCalibration(CameraIntrinsics intrinsics, boolean estimated) {
    this.intrinsics = intrinsics;
    this.estimated = estimated;
  }

  /** At the resolution of the stream, the sensor's orientation. */
  public CameraIntrinsics getIntrinsics() {
    return intrinsics;
  }

  /**
   * Whether the device told no calibration, and focal length and sensor size stand in for it: a few
   * per cent off, no distortion. Tracking works, less well; calibrate the device where it matters.
   */
  public boolean isEstimated() {
    return estimated;
  }
}
