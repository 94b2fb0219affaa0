package io.github.glideslam;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.nio.LongBuffer;

/**
 * Landmarks: x y z and confidence (0 to 1) of each, and ids that stay with a landmark. Taken at one
 * moment; it does not change. Any thread until it is closed.
 */
public final class PointCloud implements AutoCloseable {
  /** Floats per point: x y z confidence. */
  public static final int FLOATS_PER_POINT = 4;

  /** A list of the library: how many there are, and as many as fit into a buffer. */
  interface Source {
    int read(ByteBuffer points);
  }

  private final long timestampNs;
  private FloatBuffer points;
  private LongBuffer ids;

  private PointCloud(Source source, long timestampNs) {
    this.timestampNs = timestampNs;
    int count = source.read(null);
    ByteBuffer structs = Layout.array(count, Layout.POINT_SIZE);
    // Another thread may have changed the list meanwhile: no more than it has, and than fits.
    count = Math.min(count, count == 0 ? 0 : source.read(structs));
    FloatBuffer floats = Layout.array(count, FLOATS_PER_POINT * Float.BYTES).asFloatBuffer();
    LongBuffer longs = Layout.array(count, Long.BYTES).asLongBuffer();
    for (int i = 0; i < count; ++i) {
      int at = i * Layout.POINT_SIZE;
      for (int k = 0; k < FLOATS_PER_POINT; ++k) {
        floats.put(structs.getFloat(at + Float.BYTES * k));
      }
      longs.put(structs.getLong(at + Layout.POINT_ID));
    }
    floats.rewind();
    longs.rewind();
    points = floats.asReadOnlyBuffer();
    ids = longs.asReadOnlyBuffer();
  }

  static PointCloud ofSession(Session session, long timestampNs) {
    return new PointCloud(buffer -> Native.pointCloud(session.handle(), buffer), timestampNs);
  }

  static PointCloud ofMap(long map) {
    return new PointCloud(buffer -> Native.mapPoints(map, buffer), 0);
  }

  /** Of the frame in whose view they are, nanoseconds; 0 for those of a {@link MapSnapshot}. */
  public long getTimestamp() {
    return timestampNs;
  }

  /** How many there are. */
  public synchronized int size() {
    return open(ids).remaining();
  }

  /** x y z confidence of each point, in the world; direct, read only, from position 0. */
  public synchronized FloatBuffer getPoints() {
    return open(points).duplicate();
  }

  /** Ids of the points, in the same order; direct, read only, from position 0. */
  public synchronized LongBuffer getIds() {
    return open(ids).duplicate();
  }

  /** Lets go of the buffers; more than once is fine. */
  @Override
  public synchronized void close() {
    points = null;
    ids = null;
  }

  private static <T> T open(T buffer) {
    if (buffer == null) {
      throw new SessionClosedException("the point cloud was closed");
    }
    return buffer;
  }
}
