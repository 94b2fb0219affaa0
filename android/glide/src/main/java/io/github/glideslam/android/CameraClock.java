package io.github.glideslam.android;

/**
 * From the times of a sensor to those of frames, immutable. A sensor's time is the start of the first
 * row's exposure; a frame's, as with ARCore, the middle of the middle row's. Both in nanoseconds of
 * SystemClock.elapsedRealtimeNanos, the clock of SensorEvent: cameras that count in another one
 * (SENSOR_INFO_TIMESTAMP_SOURCE_UNKNOWN) are moved to it, to within what the device does not tell.
 */
final class CameraClock {
  private final long offsetNs;

  private CameraClock(long offsetNs) {
    this.offsetNs = offsetNs;
  }

  /** Of a camera whose source is REALTIME. */
  static CameraClock realtime() {
    return new CameraClock(0);
  }

  /**
   * Of a camera whose source is UNKNOWN: taken to be System.nanoTime, which stands still while the
   * device sleeps. Both clocks read now; a device does not sleep while its camera runs.
   */
  static CameraClock uptime(long elapsedRealtimeNs, long nanoTime) {
    return new CameraClock(elapsedRealtimeNs - nanoTime);
  }

  /** All nanoseconds; what is not known is 0. */
  long frameTime(long sensorNs, long exposureNs, long skewNs) {
    return sensorNs + offsetNs + exposureNs / 2 + skewNs / 2;
  }
}
