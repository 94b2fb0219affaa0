package io.github.glideslam.android;

import java.util.Arrays;

/**
 * Exposure and rolling shutter of the last frames. Written by the camera's thread, read by the one
 * that tracks; a frame may come before or after what is told about it.
 */
final class FrameTimings {
  // More than a camera has in flight.
  private static final int KEPT = 16;

  /** Of one frame; filled by {@link #find}. */
  static final class Timing {
    long exposureNs;
    long skewNs;
  }

  private final long[] sensorNs = new long[KEPT];
  private final long[] exposureNs = new long[KEPT];
  private final long[] skewNs = new long[KEPT];
  private int last;

  FrameTimings() {
    Arrays.fill(sensorNs, Long.MIN_VALUE);
  }

  synchronized void add(long frameSensorNs, long frameExposureNs, long frameSkewNs) {
    last = (last + 1) % KEPT;
    sensorNs[last] = frameSensorNs;
    exposureNs[last] = frameExposureNs;
    skewNs[last] = frameSkewNs;
  }

  /** Of the frame with that time, else of the last one that was told about: they change slowly. */
  synchronized void find(long frameSensorNs, Timing timing) {
    int found = last;
    for (int i = 0; i < KEPT; ++i) {
      if (sensorNs[i] == frameSensorNs) {
        found = i;
      }
    }
    timing.exposureNs = exposureNs[found];
    timing.skewNs = skewNs[found];
  }
}
