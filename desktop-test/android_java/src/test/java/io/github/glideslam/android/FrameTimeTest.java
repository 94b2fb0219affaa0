package io.github.glideslam.android;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public final class FrameTimeTest {
  @Test
  public void aFramesTimeIsTheMiddleOfItsMiddleRowsExposure() {
    assertEquals(1000 + 100 + 15, CameraClock.realtime().frameTime(1000, 200, 30));
    assertEquals(1000, CameraClock.realtime().frameTime(1000, 0, 0));
  }

  @Test
  public void timesOfAnUptimeClockMoveByWhatTheDeviceSlept() {
    long slept = 5_000_000_000L;
    CameraClock clock = CameraClock.uptime(7_000_000_000L + slept, 7_000_000_000L);
    assertEquals(8_000_000_000L + slept, clock.frameTime(8_000_000_000L, 0, 0));
  }

  @Test
  public void timingsAreFoundByTheSensorsTimeInAnyOrder() {
    FrameTimings timings = new FrameTimings();
    for (int i = 0; i < 100; ++i) {
      timings.add(1000 + i, i, 2 * i);
    }
    FrameTimings.Timing found = new FrameTimings.Timing();
    timings.find(1090, found);
    assertEquals(90, found.exposureNs);
    assertEquals(180, found.skewNs);
  }

  @Test
  public void aFrameWithoutTimingGetsThatOfTheLastOne() {
    FrameTimings timings = new FrameTimings();
    FrameTimings.Timing found = new FrameTimings.Timing();
    timings.find(1, found);
    assertEquals(0, found.exposureNs);
    timings.add(1000, 5, 6);
    timings.add(2000, 7, 8);
    timings.find(3000, found);
    assertEquals(7, found.exposureNs);
    assertEquals(8, found.skewNs);
  }
}
