package io.github.glideslam;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** A session that has tracked the first frames of the walk. */
abstract class TrackedTest {
  static final int FED = 14;

  final Sequence sequence = Sequence.walk();
  Session session;
  Frame frame;

  @BeforeEach
  void track() {
    session = new Session(sequence.config());
    frame = sequence.feed(session, 0, FED);
  }

  @AfterEach
  void close() {
    session.close();
  }

  Frame feedNext() {
    return sequence.feed(session, FED, FED + 1);
  }

  static float[] column(float[] matrix, int number) {
    return java.util.Arrays.copyOfRange(matrix, 4 * number, 4 * number + 3);
  }
}
