package io.github.glideslam;

import java.nio.ByteBuffer;

/**
 * The functions of libglide_jni (jni/). Each throws the exception of the status that its C function
 * returned. Structs travel in direct buffers of native order, laid out as {@link Layout} says; texts
 * as UTF-8, since JNI's own encoding is another one.
 */
final class Native {
  private static final String LIBRARY = "glide_jni";

  /** Why the library could not be loaded, null when it was. A class fails to initialise only once
   * with a reason: so it does not fail, and who makes a session is told each time. */
  private static final LinkageError FAILURE = load();

  private static LinkageError load() {
    try {
      System.loadLibrary(LIBRARY);
      return null;
    } catch (LinkageError e) { // also when it has not the functions below: of another version
      return e;
    }
  }

  /** Before the first native function: an UnsatisfiedLinkError unless the library is there. */
  static void requireLibrary() {
    if (FAILURE != null) {
      UnsatisfiedLinkError error = new UnsatisfiedLinkError(
          System.mapLibraryName(LIBRARY) + " could not be loaded (" + FAILURE.getMessage()
              + "); java.library.path is " + System.getProperty("java.library.path"));
      error.initCause(FAILURE);
      throw error;
    }
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

  static native long acquireFrameMap(long session);

  static native void releaseMap(long map);

  static native long mapRevision(long map);

  static native long mapGeneration(long map);

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
