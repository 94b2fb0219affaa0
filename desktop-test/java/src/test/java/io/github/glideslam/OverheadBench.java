package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Locale;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * What a frame costs in Java more than in C++: the time around Session.update less the time within
 * the C++ Session::update, which the frame tells. That is JNI, the C ABI and two readings of a clock.
 * Run by: run_tests.sh BUILD SOURCE -Dgroups=bench -DexcludedGroups= -Dchecks=
 */
@Tag("bench")
class OverheadBench {
  private static final int WARM_UP = 500;
  private static final int FRAMES = 2000;
  private static final double MOST_MICROS = 50;
  private static final long FRAME_NS = 33_333_333;

  @Test
  @DisplayName("a blank frame of 64x48: the library does next to nothing")
  void smallest() {
    CameraIntrinsics camera = new CameraIntrinsics(64, 48, 60, 60, 31.5, 23.5);
    Config config = new Config(camera).setBackend(Config.Backend.CPU);
    measure("blank 64x48", config, new ByteBuffer[] {ByteBuffer.allocateDirect(64 * 48)});
  }

  @Test
  @DisplayName("a tracked walk of 320x240, to and fro")
  void tracked() {
    Sequence sequence = Sequence.walk();
    ByteBuffer[] images = new ByteBuffer[2 * sequence.size() - 2];
    for (int i = 0; i < images.length; ++i) {
      images[i] = sequence.image(i < sequence.size() ? i : images.length - i);
    }
    measure("walk 320x240", sequence.config().setDeterministic(false), images);
  }

  private static void measure(String what, Config config, ByteBuffer[] images) {
    double[] update = new double[FRAMES];
    double[] within = new double[FRAMES];
    double[] getters = new double[FRAMES];
    CameraInput.Luma input =
        new CameraInput.Luma(config.getCamera().width(), config.getCamera().height());
    float[] matrix = new float[16];
    double[] pose = new double[7];
    int tracked = 0;
    try (Session session = new Session(config)) {
      for (int i = 0; i < WARM_UP + FRAMES; ++i) {
        input.set(images[i % images.length], input.getWidth(), 1, (i + 1) * FRAME_NS);
        long begin = System.nanoTime();
        Frame frame = session.update(input);
        long middle = System.nanoTime();
        frame.getCamera().getPose(pose, 0);
        frame.getCamera().getViewMatrix(matrix, 0);
        frame.getCamera().getProjectionMatrix(matrix, 0, 0.1f, 100);
        long end = System.nanoTime();
        int at = Math.max(0, i - WARM_UP);
        within[at] = frame.getStats().getUpdateMillis() * 1e3;
        update[at] = (middle - begin) / 1e3 - within[at];
        getters[at] = (end - middle) / 1e3;
        tracked += frame.getCamera().getTrackingState() == TrackingState.TRACKING ? 1 : 0;
      }
    }
    double median = quantile(update, 0.5);
    System.out.printf(
        Locale.ROOT,
        "%s: us per frame, median / p99: within Session::update %.1f / %.1f; Java, JNI and C around"
            + " it %.2f / %.2f; pose and both matrices %.2f / %.2f; %d of %d tracked%n",
        what, quantile(within, 0.5), quantile(within, 0.99), median, quantile(update, 0.99),
        quantile(getters, 0.5), quantile(getters, 0.99), tracked, WARM_UP + FRAMES);
    assertTrue(median < MOST_MICROS, median + " us");
  }

  private static double quantile(double[] values, double share) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    return sorted[(int) (share * (sorted.length - 1))];
  }
}
