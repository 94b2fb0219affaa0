package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Pure Java: needs no native library. */
class PoseTest {
  private static final float EPS = 1e-6f;
  private static final float HALF = (float) Math.sqrt(0.5);
  /** A quarter turn about z, then a step. */
  private static final Pose QUARTER =
      new Pose(new float[] {1, 2, 3}, new float[] {0, 0, HALF, HALF});

  @Test
  @DisplayName("a point is rotated first and moved then")
  void transformsPoints() {
    assertArrayEquals(new float[] {1, 3, 3}, QUARTER.transformPoint(new float[] {1, 0, 0}), EPS);
    assertArrayEquals(new float[] {-1, 0, 0}, QUARTER.rotateVector(new float[] {0, 1, 0}), EPS);
  }

  @Test
  @DisplayName("compose applies the right pose first")
  void composes() {
    Pose both = QUARTER.compose(Pose.makeTranslation(1, 0, 0));
    assertArrayEquals(new float[] {1, 3, 3}, both.getTranslation(), EPS);
    assertArrayEquals(QUARTER.getRotationQuaternion(), both.getRotationQuaternion(), EPS);
    Pose turn = Pose.makeRotation(HALF, 0, 0, HALF);
    float[] p = {0.3f, -0.7f, 2};
    assertArrayEquals(
        QUARTER.transformPoint(turn.transformPoint(p)),
        QUARTER.compose(turn).transformPoint(p), EPS);
  }

  @Test
  @DisplayName("the inverse undoes a pose on both sides")
  void inverts() {
    float[] p = {0.3f, -0.7f, 2};
    assertArrayEquals(p, QUARTER.inverse().compose(QUARTER).transformPoint(p), EPS);
    assertArrayEquals(p, QUARTER.compose(QUARTER.inverse()).transformPoint(p), EPS);
  }

  @Test
  @DisplayName("the matrix is column-major")
  void matrix() {
    float[] m = new float[17];
    QUARTER.toMatrix(m, 1);
    assertArrayEquals(
        new float[] {0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}, m, EPS);
  }

  @Test
  @DisplayName("axes are the matrix' columns")
  void axes() {
    assertArrayEquals(new float[] {0, 1, 0}, QUARTER.getXAxis(), EPS);
    assertArrayEquals(new float[] {-1, 0, 0}, QUARTER.getYAxis(), EPS);
    assertArrayEquals(new float[] {0, 0, 1}, QUARTER.getZAxis(), EPS);
  }

  @Test
  @DisplayName("parts of a pose are taken out alone")
  void parts() {
    assertArrayEquals(new float[3], QUARTER.extractRotation().getTranslation(), 0);
    assertArrayEquals(
        new float[] {0, 0, 0, 1}, QUARTER.extractTranslation().getRotationQuaternion(), 0);
    assertEquals(2, QUARTER.ty());
    assertEquals(HALF, QUARTER.qz(), EPS);
  }

  @Test
  @DisplayName("half way between two poses is half the angle, the shorter way round")
  void interpolates() {
    Pose middle = Pose.makeInterpolated(Pose.IDENTITY, QUARTER, 0.5f);
    float eighth = (float) Math.sin(Math.PI / 8);
    assertArrayEquals(new float[] {0.5f, 1, 1.5f}, middle.getTranslation(), EPS);
    assertEquals(eighth, middle.qz(), EPS);
    Pose negative = new Pose(new float[] {1, 2, 3}, new float[] {0, 0, -HALF, -HALF});
    assertEquals(eighth, Math.abs(Pose.makeInterpolated(Pose.IDENTITY, negative, 0.5f).qz()), EPS);
    Pose same = Pose.makeInterpolated(QUARTER, QUARTER, 0.3f);
    assertArrayEquals(QUARTER.getRotationQuaternion(), same.getRotationQuaternion(), EPS);
  }

  @Test
  @DisplayName("arrays with offsets give what the allocating methods give, also in place")
  void offsets() {
    float[] values = {9, 1, 2, 3, 9};
    QUARTER.transformPoint(values, 1, values, 1);
    assertArrayEquals(
        QUARTER.transformPoint(new float[] {1, 2, 3}),
        java.util.Arrays.copyOfRange(values, 1, 4), EPS);
    assertEquals(9, values[0]);
    assertEquals(9, values[4]);
    float[] rotated = new float[4];
    QUARTER.rotateVector(new float[] {1, 2, 3}, 0, rotated, 1);
    assertArrayEquals(
        QUARTER.rotateVector(new float[] {1, 2, 3}),
        java.util.Arrays.copyOfRange(rotated, 1, 4), EPS);
    float[] axis = new float[3];
    QUARTER.getTransformedAxis(1, 2, axis, 0);
    assertArrayEquals(new float[] {-2, 0, 0}, axis, EPS);
    float[] parts = new float[7];
    QUARTER.getTranslation(parts, 0);
    QUARTER.getRotationQuaternion(parts, 3);
    assertArrayEquals(new float[] {1, 2, 3, 0, 0, HALF, HALF}, parts, EPS);
  }

  @Test
  @DisplayName("a quaternion is normalised, and refused when it is none")
  void normalises() {
    assertEquals(1, Pose.makeRotation(0, 0, 0, 2).qw(), EPS);
    assertThrows(InvalidArgumentException.class, () -> Pose.makeRotation(0, 0, 0, 0));
    assertThrows(InvalidArgumentException.class, () -> Pose.makeRotation(Float.NaN, 0, 0, 1));
    assertThrows(
        InvalidArgumentException.class, () -> new Pose(new float[2], new float[] {0, 0, 0, 1}));
  }

  @Test
  @DisplayName("a pose comes back from a struct as it was")
  void struct() {
    ByteBuffer struct = Layout.array(2, Layout.POSE_SIZE);
    QUARTER.write(struct, Layout.POSE_SIZE);
    double[] exact = new double[7];
    double[] read = new double[9];
    QUARTER.getExact(exact, 0);
    Pose.copy(struct, Layout.POSE_SIZE, read, 1);
    assertArrayEquals(exact, java.util.Arrays.copyOfRange(read, 1, 8), 1e-15);
    double[] again = new double[7];
    Pose.read(struct, Layout.POSE_SIZE).getExact(again, 0);
    assertArrayEquals(exact, again, 1e-15);
  }

  @Test
  @DisplayName("a pose prints as ARCore's do")
  void text() {
    assertEquals(
        "t:[x:1.000, y:2.000, z:3.000], q:[x:0.000, y:0.000, z:0.707, w:0.707]",
        QUARTER.toString());
  }
}
