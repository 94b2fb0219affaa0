package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * The functions of libglide_jni (jni/). Each throws the exception of the status that its C function
 * returned. Structs travel in direct buffers of native order, laid out as {@link Layout} says; texts
 * as UTF-8, since JNI's own encoding is another one.
 */
final class Native {
  static {
    System.loadLibrary("glide_jni");
  }

  static native int[] layout();

  static native String version();

  /** {@code settings}: "name=value" texts, each ended by a zero. */
  static native long create(ByteBuffer config, byte[] settings);

  static native void destroy(long session);

  static native void pause(long session);

  static native void resume(long session);

  static native void reset(long session);

  /** {@code pixels} and {@code hardwareBuffer} (an android.hardware.HardwareBuffer) may be null. */
  static native void update(
      long session, ByteBuffer image, ByteBuffer pixels, Object hardwareBuffer, ByteBuffer frame);

  static native void waitForMapping(long session);

  static native void releaseGl(long session);

  static native void abandonGl(long session);

  static native void backend(long session, ByteBuffer info);

  static native void pushImu(long session, ByteBuffer samples);

  static native void locate(long session, long timeNs, ByteBuffer location);

  static native void setMetricScale(long session, float metresPerUnit);

  static native void setGravity(long session, float x, float y, float z);

  static native void setDisplay(long session, int rotationDegrees, int width, int height);

  static native void viewMatrix(long session, float[] matrix, int offset);

  static native void projectionMatrix(
      long session, float near, float far, float[] matrix, int offset);

  /** How many there are; as many as fit are written, none into null. So are the other lists. */
  static native int pointCloud(long session, ByteBuffer points);

  static native int trackedPoints(long session, ByteBuffer points);

  static native int hitTest(long session, float x, float y, ByteBuffer hits);

  static native long createAnchor(long session, ByteBuffer pose);

  static native void anchor(long session, long anchor, ByteBuffer state);

  static native void destroyAnchor(long session, long anchor);

  static native long acquireMap(long session);

  static native void releaseMap(long map);

  static native long mapRevision(long map);

  static native int mapPoints(long map, ByteBuffer points);

  static native int mapKeyframes(long map, ByteBuffer keyframes);

  static native int mapLoops(long map, ByteBuffer loops);

  static native void mapCorrectedCamera(long map, ByteBuffer camera);

  static native void saveMap(long session, byte[] path);

  static native void loadMap(long session, byte[] path);

  static native byte[] saveMapBytes(long session);

  static native void loadMapBytes(long session, byte[] map);

  private Native() {}
}
