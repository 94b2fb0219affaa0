package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class ManySessionsTest {
  private static final int WARM_UP_CYCLES = 200;
  private static final int BLOCKS = 4;
  private static final int BLOCK_CYCLES = 250;
  // What is in use does not grow by a byte (CDestroy.LeavesNothingBehind, in C). What the process holds did, to 100 MB and
  // more: glibc puts the next session's images where the first one's were freed, among what the JVM has allocated
  // since (direct buffers, compiled code), and cannot give such pieces back. pom.xml makes it map what is large, and
  // keep to one heap; the JVM's own warming up is left. A leak grows in every block: 1 kB a session, an image has 77.
  private static final long MOST_GROWTH_KB = 256;

  private final Sequence sequence = Sequence.walk();
  private final ByteBuffer image = sequence.image(0);

  @Test
  @DisplayName("two sessions at once, each on its thread, do not disturb each other")
  void twoAtOnce() throws Exception {
    Callable<double[]> walk = () -> {
      double[] pose = new double[7];
      try (Session session = new Session(sequence.config())) {
        sequence.feed(session, 0, sequence.size()).getCamera().getPose(pose, 0);
      }
      return pose;
    };
    ExecutorService threads = Executors.newFixedThreadPool(2);
    try {
      double[] expected = sequence.references.get(sequence.size() - 1).pose();
      for (Future<double[]> result : threads.invokeAll(List.of(walk, walk))) {
        for (int i = 0; i < 3; ++i) {
          assertEquals(expected[i], result.get()[i], 1e-9);
        }
      }
    } finally {
      threads.shutdown();
    }
  }

  @Test
  @DisplayName("two sessions on one thread take turns, and one closes without the other")
  void interleaved() {
    try (Session first = new Session(sequence.config())) {
      try (Session second = new Session(sequence.config())) {
        for (int i = 0; i < 20; ++i) {
          sequence.feed(first, i, i + 1);
          sequence.feed(second, i, i + 1);
        }
      }
      Frame frame = sequence.feed(first, 20, sequence.size());
      double[] expected = sequence.references.get(sequence.size() - 1).pose();
      double[] pose = new double[7];
      frame.getCamera().getPose(pose, 0);
      assertEquals(expected[0], pose[0], 1e-9);
    }
  }

  @Test
  @DisplayName("a thousand sessions that are opened, used and closed leave nothing behind")
  void cycles() throws IOException {
    cycle(WARM_UP_CYCLES);
    long growth = Long.MAX_VALUE;
    for (int block = 0; block < BLOCKS; ++block) {
      long before = residentKb();
      cycle(BLOCK_CYCLES);
      growth = Math.min(growth, residentKb() - before);
    }
    assertTrue(growth < MOST_GROWTH_KB, "every block of sessions grew by " + growth + " kB or more");
  }

  @Test
  @DisplayName("a session may be closed while another thread tracks with it")
  void closedMeanwhile() throws Exception {
    ExecutorService thread = Executors.newSingleThreadExecutor();
    try {
      for (int i = 0; i < 20; ++i) {
        Session session = new Session(sequence.config());
        Future<?> tracking = thread.submit(() -> {
          try {
            sequence.feed(session, 0, 5);
          } catch (SessionClosedException e) {
            assertTrue(session.isClosed());
          }
        });
        session.close();
        tracking.get();
      }
    } finally {
      thread.shutdown();
    }
  }

  private void cycle(int count) {
    CameraInput.Luma input = sequence.input().set(image, sequence.camera.width(), 1, 1);
    for (int i = 0; i < count; ++i) {
      try (Session session = new Session(sequence.config())) {
        session.update(input);
      }
    }
  }

  private static long residentKb() throws IOException {
    System.gc();
    for (String line : Files.readAllLines(Paths.get("/proc/self/status"))) {
      if (line.startsWith("VmRSS:")) {
        return Long.parseLong(line.replaceAll("\\D", ""));
      }
    }
    throw new IOException("/proc/self/status has no VmRSS");
  }
}
