package io.github.glideslam;

import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.util.Collection;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Tracks one camera. Lengths are in arbitrary scene units until {@link #setMetricScale}: one camera
 * knows no scale. The world is the first keyframe's camera, in GL axes (x right, y up, z backwards),
 * turned upright by {@link #setGravityHint}. A new map, also after {@link #reset} and {@link #loadMap},
 * is a new world: {@link Frame#getMapGeneration} grows, scale and gravity are arbitrary again.
 *
 * <table>
 *   <caption>Threads</caption>
 *   <tr><th>call</th><th>thread</th></tr>
 *   <tr><td>{@link #update}, {@link #releaseGl}</td><td>with OpenGL ES one thread, the app's context
 *     current; with the CPU backend any. Elsewhere: {@link WrongThreadException}</td></tr>
 *   <tr><td>{@link Frame}, {@link Camera}, {@link FrameStats}, {@link TrackedPoints}</td><td>the thread
 *     that calls update: update and {@link Frame#getTrackedPoints} fill them again</td></tr>
 *   <tr><td>{@link #close}</td><td>that thread too, or any after {@link #releaseGl} or
 *     {@link #abandonGl}; elsewhere GL objects are leaked. Waits for calls of other threads</td></tr>
 *   <tr><td>everything else</td><td>any</td></tr>
 * </table>
 *
 * <p>update, {@link #releaseGl}, {@link #abandonGl}, {@link #pause}, {@link #resume}, {@link #reset}
 * and the end of {@link #loadMap} take turns: each waits for an update that is under way. Nothing else
 * does, and update never waits for a file, nor for mapping, but with {@link Config#setDeterministic}:
 * it then does the mapping itself.
 *
 * <p>Everything throws {@link SessionClosedException} after {@link #close}.
 */
public final class Session implements AutoCloseable {
  private final AtomicLong handle;
  private final Config config;
  private final Frame frame = new Frame(this);
  private volatile boolean paused;

  private final ByteBuffer imuSample = Layout.array(1, Layout.IMU_SIZE);
  private final AnchorList anchors = new AnchorList();

  /**
   * Needs no GL context. InvalidArgumentException names a value of {@code config} that is out of
   * range. UnsatisfiedLinkError when there is no native library, each time.
   */
  public Session(Config config) {
    if (config == null) {
      throw new InvalidArgumentException("config is null");
    }
    this.config = new Config(config);
    Native.requireLibrary();
    handle = new AtomicLong(Native.create(config.struct(), config.settings()));
  }

  /** The library's version, for instance "0.1.0". */
  public static String getLibraryVersion() {
    Native.requireLibrary();
    return Native.version();
  }

  /**
   * Tracks one frame. The same {@link Frame} each time, filled again; nothing is allocated. A camera
   * that is lost is no failure: see {@link Camera#getTrackingState}. SessionPausedException while
   * paused; TimestampOrderException when time does not increase; MissingGlContextException and
   * WrongThreadException with OpenGL ES.
   */
  public Frame update(CameraInput input) {
    if (input == null) {
      throw new InvalidArgumentException("input is null");
    }
    Native.update(
        handle(), input.struct, input.pixels(), input.hardwareBuffer(), frame.struct);
    frame.setFilled();
    anchors.setStale();
    return frame;
  }

  /** Stops taking frames; the map stays. More than once is fine. */
  public void pause() {
    Native.pause(handle());
    paused = true;
  }

  /** Takes frames again; a session is made so. More than once is fine. */
  public void resume() {
    Native.resume(handle());
    paused = false;
  }

  /**
   * Drops the map: scale and gravity are arbitrary again. Anchors stay but are no longer tracked
   * (STOPPED, for good): detach them.
   */
  public void reset() {
    Native.reset(handle());
  }

  /**
   * Blocks until every keyframe so far is mapped, and loops that this closed are worked in: for files,
   * where the next frame can wait.
   */
  public void waitForMapping() {
    Native.waitForMapping(handle());
  }

  /** Frees all GL objects, while their context is current. The next update makes them anew. */
  public void releaseGl() {
    Native.releaseGl(handle());
  }

  /** Forgets all GL objects, when their context is gone. The next update makes them anew. */
  public void abandonGl() {
    Native.abandonGl(handle());
  }

  /** Where the direct tracker runs. */
  public BackendInfo getBackend() {
    ByteBuffer info = Layout.struct(Layout.BACKEND_SIZE);
    Native.backend(handle(), info);
    return new BackendInfo(info);
  }

  /**
   * An IMU sample: nanoseconds in the camera's clock, m/s2 and rad/s in the device's axes. Kept for
   * later versions; poses do not use it yet. TimestampOrderException when time does not increase.
   */
  // NOLINTNEXTLINE(readability-function-size): one call per sample, without an object
  public void pushImu(
      long timestampNs, float ax, float ay, float az, float wx, float wy, float wz) {
    synchronized (imuSample) {
      imuSample.putLong(0, timestampNs);
      int a = Layout.IMU_ACCELERATION;
      imuSample.putFloat(a, ax).putFloat(a + 4, ay).putFloat(a + 8, az);
      int w = Layout.IMU_ANGULAR_VELOCITY;
      imuSample.putFloat(w, wx).putFloat(w + 4, wy).putFloat(w + 8, wz);
      Native.pushImu(handle(), imuSample);
    }
  }

  /** {@link #locate(long, PoseSample)} into a new object. */
  public PoseSample locate(long timestampNs) {
    return locate(timestampNs, new PoseSample());
  }

  /**
   * Where the camera was at a time of its clock, or will be up to 100 ms ahead. Fills and returns
   * {@code sample}; never fails for a time, see {@link PoseSample#isValid}.
   */
  public PoseSample locate(long timestampNs, PoseSample sample) {
    if (sample == null) {
      throw new InvalidArgumentException("sample is null");
    }
    Native.locate(handle(), timestampNs, sample.struct);
    return sample;
  }

  /**
   * Metres per present scene unit: what shows as 2 and is 1 m long: 0.5. Poses, points and anchors
   * change at once. NotTrackingException unless the last frame was tracked.
   */
  public void setMetricScale(float metresPerUnit) {
    Native.setMetricScale(handle(), metresPerUnit);
  }

  /**
   * Direction of gravity (down) in the camera's GL axes at the last frame: the world's y axis then
   * points up. NotTrackingException unless the last frame was tracked.
   */
  public void setGravityHint(float x, float y, float z) {
    Native.setGravity(handle(), x, y, z);
  }

  /**
   * By how much the camera's image is turned clockwise to be upright on the display (0, 90, 180 or
   * 270 degrees), and the display's size in pixels: for the view and projection matrices.
   */
  public void setDisplayGeometry(int rotationDegrees, int width, int height) {
    Native.setDisplay(handle(), rotationDegrees, width, height);
  }

  /**
   * An anchor at a pose of the world: one that the last frame told, or a hit in it, before the next
   * update. A pose that was kept may be of a map that has been corrected or replaced since.
   * NotTrackingException while there is no map; there is one in every frame that is TRACKING.
   */
  public Anchor createAnchor(Pose pose) {
    if (pose == null) {
      throw new InvalidArgumentException("pose is null");
    }
    ByteBuffer struct = Layout.array(1, Layout.POSE_SIZE);
    pose.write(struct, 0);
    return anchors.add(new Anchor(this, Native.createAnchor(handle(), struct)));
  }

  /** All that are not detached. A copy. */
  public Collection<Anchor> getAllAnchors() {
    return anchors.copy();
  }

  /**
   * The newest map, complete; close it. It may be corrected already where the last frame is not: its
   * poses are none to make anchors at. Empty while there is no map.
   */
  public MapSnapshot acquireMap() {
    return new MapSnapshot(Native.acquireMap(handle()));
  }

  /**
   * The complete map that the last frame was tracked in, which its pose, points, hits and anchors are
   * of; close it. Empty while there is no map.
   */
  public MapSnapshot acquireFrameMap() {
    return new MapSnapshot(Native.acquireFrameMap(handle()));
  }

  /**
   * Writes the map to a file. Does not hold up update. MapIoException; NotTrackingException while
   * there is no map.
   */
  public void saveMap(String path) {
    Native.saveMap(handle(), MapStreams.path(path));
  }

  /**
   * Takes the map of a file in the place of the present one, or changes nothing:
   * DataInvalidFormatException, DataUnsupportedVersionException, MapIoException,
   * InvalidArgumentException (a map of another camera).
   */
  public void loadMap(String path) {
    Native.loadMap(handle(), MapStreams.path(path));
  }

  /**
   * {@link #saveMap(String)} to a stream, which is flushed. MapIoException with the stream's as its
   * cause.
   */
  public void saveMap(OutputStream stream) {
    if (stream == null) {
      throw new InvalidArgumentException("stream is null");
    }
    MapStreams.write(Native.saveMapBytes(handle()), stream);
  }

  /** {@link #loadMap(String)} from what is left of a stream. */
  public void loadMap(InputStream stream) {
    Native.loadMapBytes(handle(), MapStreams.read(stream));
  }

  /** Ends mapping and frees everything; more than once is fine. May take some seconds. */
  @Override
  public void close() {
    Native.destroy(handle.getAndSet(0));
  }

  long handle() {
    long open = handle.get();
    if (open == 0) {
      throw new SessionClosedException("the session is closed");
    }
    return open;
  }

  boolean isClosed() {
    return handle.get() == 0;
  }

  boolean isPaused() {
    return paused;
  }

  Config config() {
    return config;
  }

  void forget(Anchor anchor) {
    anchors.remove(anchor);
    long open = handle.get();
    if (open != 0) {
      Native.destroyAnchor(open, anchor.id());
    }
  }

  Collection<Anchor> updatedAnchors() {
    return anchors.updated();
  }
}
