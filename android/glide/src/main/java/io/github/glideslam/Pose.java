package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * A rigid transform, immutable: rotation (unit quaternion x y z w) first, then translation. Lengths
 * are scene units, metres once a metric scale is set. The methods of com.google.ar.core.Pose; values
 * are kept in double.
 */
public final class Pose {
  /** No rotation, no translation. */
  public static final Pose IDENTITY = new Pose(0, 0, 0, 0, 0, 0, 1);

  private final double tx;
  private final double ty;
  private final double tz;
  private final double qx;
  private final double qy;
  private final double qz;
  private final double qw;

  /** From translation x y z and quaternion x y z w; the quaternion is normalised. */
  public Pose(float[] translation, float[] rotation) {
    this(
        checked(translation, 3)[0], translation[1], translation[2],
        checked(rotation, 4)[0], rotation[1], rotation[2], rotation[3]);
  }

  private static float[] checked(float[] values, int length) {
    if (values == null || values.length != length) {
      throw new InvalidArgumentException("a pose needs arrays of 3 and 4 elements");
    }
    return values;
  }

  // NOLINTNEXTLINE(readability-function-size): a pose is so many numbers
  private Pose(double tx, double ty, double tz, double qx, double qy, double qz, double qw) {
    double norm = Math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw);
    if (!(norm > 0)) {
      throw new InvalidArgumentException("the quaternion of a pose is zero or not a number");
    }
    this.tx = tx;
    this.ty = ty;
    this.tz = tz;
    this.qx = qx / norm;
    this.qy = qy / norm;
    this.qz = qz / norm;
    this.qw = qw / norm;
  }

  /** A translation alone. */
  public static Pose makeTranslation(float tx, float ty, float tz) {
    return new Pose(tx, ty, tz, 0, 0, 0, 1);
  }

  /** A rotation alone: quaternion x y z w, which is normalised. */
  public static Pose makeRotation(float x, float y, float z, float w) {
    return new Pose(0, 0, 0, x, y, z, w);
  }

  /** Between a (t = 0) and b (t = 1): straight for the translation, the shorter arc for the rotation. */
  public static Pose makeInterpolated(Pose a, Pose b, float t) {
    double s = 1 - t;
    double dot = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw;
    double sign = dot < 0 ? -1 : 1;
    double angle = Math.acos(Math.min(1, Math.abs(dot)));
    double sin = Math.sin(angle);
    // Nearly the same rotation: the chord is the arc.
    double wa = sin > 1e-6 ? Math.sin(s * angle) / sin : s;
    double wb = sign * (sin > 1e-6 ? Math.sin(t * angle) / sin : t);
    return new Pose(
        s * a.tx + t * b.tx, s * a.ty + t * b.ty, s * a.tz + t * b.tz,
        wa * a.qx + wb * b.qx, wa * a.qy + wb * b.qy, wa * a.qz + wb * b.qz, wa * a.qw + wb * b.qw);
  }

  /** This after {@code rhs}: maps p to this(rhs(p)). */
  public Pose compose(Pose rhs) {
    double[] t = {rhs.tx, rhs.ty, rhs.tz};
    rotate(t);
    return new Pose(
        tx + t[0], ty + t[1], tz + t[2],
        qw * rhs.qx + qx * rhs.qw + qy * rhs.qz - qz * rhs.qy,
        qw * rhs.qy - qx * rhs.qz + qy * rhs.qw + qz * rhs.qx,
        qw * rhs.qz + qx * rhs.qy - qy * rhs.qx + qz * rhs.qw,
        qw * rhs.qw - qx * rhs.qx - qy * rhs.qy - qz * rhs.qz);
  }

  /** Maps this(p) to p. */
  public Pose inverse() {
    Pose unrotated = new Pose(0, 0, 0, -qx, -qy, -qz, qw);
    double[] t = {-tx, -ty, -tz};
    unrotated.rotate(t);
    return new Pose(t[0], t[1], t[2], -qx, -qy, -qz, qw);
  }

  /** The rotation alone. */
  public Pose extractRotation() {
    return new Pose(0, 0, 0, qx, qy, qz, qw);
  }

  /** The translation alone. */
  public Pose extractTranslation() {
    return new Pose(tx, ty, tz, 0, 0, 0, 1);
  }

  /** Rotates and translates a point. */
  public float[] transformPoint(float[] point) {
    double[] p = {point[0], point[1], point[2]};
    rotate(p);
    return new float[] {(float) (p[0] + tx), (float) (p[1] + ty), (float) (p[2] + tz)};
  }

  /** Rotates a vector. */
  public float[] rotateVector(float[] vector) {
    double[] v = {vector[0], vector[1], vector[2]};
    rotate(v);
    return new float[] {(float) v[0], (float) v[1], (float) v[2]};
  }

  /** The same for in[inOffset .. inOffset+2], to out[outOffset .. outOffset+2]; both may be one array. */
  public void transformPoint(float[] in, int inOffset, float[] out, int outOffset) {
    double[] p = {in[inOffset], in[inOffset + 1], in[inOffset + 2]};
    rotate(p);
    out[outOffset] = (float) (p[0] + tx);
    out[outOffset + 1] = (float) (p[1] + ty);
    out[outOffset + 2] = (float) (p[2] + tz);
  }

  /** The same for in[inOffset .. inOffset+2], to out[outOffset .. outOffset+2]; both may be one array. */
  public void rotateVector(float[] in, int inOffset, float[] out, int outOffset) {
    double[] v = {in[inOffset], in[inOffset + 1], in[inOffset + 2]};
    rotate(v);
    out[outOffset] = (float) v[0];
    out[outOffset + 1] = (float) v[1];
    out[outOffset + 2] = (float) v[2];
  }

  /** Axis 0 (x), 1 (y) or 2 (z) of this frame in its parent, {@code scale} long, to dest[offset .. offset+2]. */
  public void getTransformedAxis(int axis, float scale, float[] dest, int offset) {
    float[] vector = {0, 0, 0};
    vector[axis] = scale;
    rotateVector(vector, 0, dest, offset);
  }

  /** v + 2 w (q x v) + 2 q x (q x v). */
  private void rotate(double[] v) {
    double cx = qy * v[2] - qz * v[1];
    double cy = qz * v[0] - qx * v[2];
    double cz = qx * v[1] - qy * v[0];
    v[0] += 2 * (qw * cx + qy * cz - qz * cy);
    v[1] += 2 * (qw * cy + qz * cx - qx * cz);
    v[2] += 2 * (qw * cz + qx * cy - qy * cx);
  }

  /** Writes the column-major 4x4 matrix to dest[offset .. offset+15]. */
  public void toMatrix(float[] dest, int offset) {
    dest[offset] = (float) (1 - 2 * (qy * qy + qz * qz));
    dest[offset + 1] = (float) (2 * (qx * qy + qz * qw));
    dest[offset + 2] = (float) (2 * (qx * qz - qy * qw));
    dest[offset + 3] = 0;
    dest[offset + 4] = (float) (2 * (qx * qy - qz * qw));
    dest[offset + 5] = (float) (1 - 2 * (qx * qx + qz * qz));
    dest[offset + 6] = (float) (2 * (qy * qz + qx * qw));
    dest[offset + 7] = 0;
    dest[offset + 8] = (float) (2 * (qx * qz + qy * qw));
    dest[offset + 9] = (float) (2 * (qy * qz - qx * qw));
    dest[offset + 10] = (float) (1 - 2 * (qx * qx + qy * qy));
    dest[offset + 11] = 0;
    dest[offset + 12] = (float) tx;
    dest[offset + 13] = (float) ty;
    dest[offset + 14] = (float) tz;
    dest[offset + 15] = 1;
  }

  /** Translation along x. */
  public float tx() {
    return (float) tx;
  }

  /** Translation along y. */
  public float ty() {
    return (float) ty;
  }

  /** Translation along z. */
  public float tz() {
    return (float) tz;
  }

  /** The quaternion's x. */
  public float qx() {
    return (float) qx;
  }

  /** The quaternion's y. */
  public float qy() {
    return (float) qy;
  }

  /** The quaternion's z. */
  public float qz() {
    return (float) qz;
  }

  /** The quaternion's w. */
  public float qw() {
    return (float) qw;
  }

  /** x y z. */
  public float[] getTranslation() {
    return new float[] {(float) tx, (float) ty, (float) tz};
  }

  /** x y z w. */
  public float[] getRotationQuaternion() {
    return new float[] {(float) qx, (float) qy, (float) qz, (float) qw};
  }

  /** x y z to dest[offset .. offset+2]. */
  public void getTranslation(float[] dest, int offset) {
    dest[offset] = (float) tx;
    dest[offset + 1] = (float) ty;
    dest[offset + 2] = (float) tz;
  }

  /** x y z w to dest[offset .. offset+3]. */
  public void getRotationQuaternion(float[] dest, int offset) {
    dest[offset] = (float) qx;
    dest[offset + 1] = (float) qy;
    dest[offset + 2] = (float) qz;
    dest[offset + 3] = (float) qw;
  }

  /** Undiminished precision: x y z, then the quaternion x y z w, to dest[offset .. offset+6]. */
  public void getExact(double[] dest, int offset) {
    dest[offset] = tx;
    dest[offset + 1] = ty;
    dest[offset + 2] = tz;
    dest[offset + 3] = qx;
    dest[offset + 4] = qy;
    dest[offset + 5] = qz;
    dest[offset + 6] = qw;
  }

  /** The x axis of this frame in its parent. */
  public float[] getXAxis() {
    return rotateVector(new float[] {1, 0, 0});
  }

  /** The y axis of this frame in its parent. */
  public float[] getYAxis() {
    return rotateVector(new float[] {0, 1, 0});
  }

  /** The z axis of this frame in its parent. */
  public float[] getZAxis() {
    return rotateVector(new float[] {0, 0, 1});
  }

  /** Of a glide_pose in a struct. */
  static Pose read(ByteBuffer struct, int at) {
    int t = at + Layout.POSE_T;
    return new Pose(
        struct.getDouble(t), struct.getDouble(t + 8), struct.getDouble(t + 16),
        struct.getDouble(at), struct.getDouble(at + 8), struct.getDouble(at + 16),
        struct.getDouble(at + 24));
  }

  /** The values of a struct as {@link #getExact} orders them. */
  static void copy(ByteBuffer struct, int at, double[] dest, int offset) {
    for (int i = 0; i < 3; ++i) {
      dest[offset + i] = struct.getDouble(at + Layout.POSE_T + Double.BYTES * i);
    }
    for (int i = 0; i < 4; ++i) {
      dest[offset + 3 + i] = struct.getDouble(at + Double.BYTES * i);
    }
  }

  /** Into a glide_pose of a struct. */
  void write(ByteBuffer struct, int at) {
    int t = at + Layout.POSE_T;
    struct.putDouble(at, qx).putDouble(at + 8, qy).putDouble(at + 16, qz).putDouble(at + 24, qw);
    struct.putDouble(t, tx).putDouble(t + 8, ty).putDouble(t + 16, tz);
  }

  @Override
  public String toString() {
    return String.format(
        java.util.Locale.ROOT,
        "t:[x:%.3f, y:%.3f, z:%.3f], q:[x:%.3f, y:%.3f, z:%.3f, w:%.3f]",
        tx, ty, tz, qx, qy, qz, qw);
  }
}
