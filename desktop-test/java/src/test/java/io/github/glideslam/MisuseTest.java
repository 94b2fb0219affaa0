package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

/** What no app should do: an exception, and a session that goes on. */
class MisuseTest extends TrackedTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 240;
  private static final int SIZE = WIDTH * HEIGHT;

  private final CameraInput.Luma input = new CameraInput.Luma(WIDTH, HEIGHT);

  private static void assertRefused(Executable call) {
    String message = assertThrows(InvalidArgumentException.class, call).getMessage();
    assertTrue(message != null && !message.isEmpty());
  }

  @Test
  @DisplayName("every call on a closed session says that it is closed")
  void closedSession() {
    session.close();
    Camera camera = frame.getCamera();
    List<Executable> calls = List.of(
        () -> feedNext(), session::pause, session::resume, session::reset, session::waitForMapping,
        session::releaseGl, session::abandonGl, session::getBackend, session::acquireMap,
        session::acquireFrameMap,
        () -> session.pushImu(1, 0, 0, 0, 0, 0, 0), () -> session.locate(1),
        () -> session.setMetricScale(1), () -> session.setGravityHint(0, -1, 0),
        () -> session.setDisplayGeometry(0, 1, 1), () -> session.createAnchor(Pose.IDENTITY),
        () -> session.saveMap("/tmp/none"), () -> session.loadMap("/tmp/none"),
        () -> camera.getViewMatrix(new float[16], 0),
        () -> camera.getProjectionMatrix(new float[16], 0, 1, 2),
        frame::acquirePointCloud, frame::getTrackedPoints, () -> frame.hitTest(1, 1));
    for (Executable call : calls) {
      assertEquals(
          "the session is closed",
          assertThrows(SessionClosedException.class, call).getMessage());
    }
  }

  @Test
  @DisplayName("pixels must be in a direct buffer that is large enough")
  void pixels() {
    ByteBuffer direct = ByteBuffer.allocateDirect(SIZE);
    assertRefused(() -> session.update(null));
    assertRefused(() -> session.update(input));
    assertRefused(() -> input.set(null, WIDTH, 1, 1));
    assertRefused(() -> input.set(ByteBuffer.allocate(SIZE), WIDTH, 1, 1));
    assertRefused(() -> input.set(ByteBuffer.allocateDirect(SIZE - 1), WIDTH, 1, 1));
    assertRefused(() -> input.set(ByteBuffer.allocateDirect(SIZE).position(1), WIDTH, 1, 1));
    assertRefused(() -> input.set(ByteBuffer.allocateDirect(SIZE).limit(SIZE - 1), WIDTH, 1, 1));
    assertRefused(() -> input.set(direct, WIDTH - 1, 1, 1));
    assertRefused(() -> input.set(direct, -WIDTH, 1, 1));
    assertRefused(() -> input.set(direct, Integer.MAX_VALUE, 1, 1));
    assertRefused(() -> input.set(direct, WIDTH, 2, 1));
    assertEquals(TrackingState.TRACKING, feedNext().getCamera().getTrackingState());
  }

  @Test
  @DisplayName("images of another size than the camera's are refused")
  void sizes() {
    assertRefused(() -> new CameraInput.Luma(0, HEIGHT));
    assertRefused(() -> new CameraInput.Texture(WIDTH, -1));
    long next = sequence.references.get(FED).timestampNs();
    CameraInput.Luma small = new CameraInput.Luma(WIDTH / 2, HEIGHT / 2);
    assertRefused(
        () -> session.update(small.set(ByteBuffer.allocateDirect(SIZE), WIDTH / 2, 1, next)));
    CameraInput.Luma huge = new CameraInput.Luma(Integer.MAX_VALUE, Integer.MAX_VALUE);
    assertRefused(() -> huge.set(ByteBuffer.allocateDirect(SIZE), Integer.MAX_VALUE, 1, next));
    CameraIntrinsics giant = new CameraIntrinsics(1 << 30, 1 << 30, 1e9, 1e9, 5e8, 5e8);
    assertRefused(() -> new Session(new Config(giant).setBackend(Config.Backend.CPU)));
    assertRefused(() -> new Session(new Config(new CameraIntrinsics(0, 0, 0, 0, 0, 0))));
    assertEquals(TrackingState.TRACKING, feedNext().getCamera().getTrackingState());
  }

  @Test
  @DisplayName("a buffer may hold the image anywhere, with gaps between rows")
  void placeAndStride() {
    int stride = WIDTH + 13;
    ByteBuffer packed = sequence.image(FED);
    ByteBuffer wide = ByteBuffer.allocateDirect(77 + stride * (HEIGHT - 1) + WIDTH);
    for (int y = 0; y < HEIGHT; ++y) {
      wide.put(77 + y * stride, packed, y * WIDTH, WIDTH);
    }
    Sequence.Reference reference = sequence.references.get(FED);
    wide.position(77);
    input.set(wide, stride, 1, reference.timestampNs());
    wide.position(0); // after set() the app may do with it what it likes
    session.update(input);
    double[] pose = new double[7];
    frame.getCamera().getPose(pose, 0);
    assertEquals(reference.pose()[0], pose[0], 1e-9);
  }

  @Test
  @DisplayName("time must go on, and a refused frame changes nothing")
  void time() {
    long last = frame.getTimestamp();
    ByteBuffer image = sequence.image(FED);
    assertThrows(
        TimestampOrderException.class, () -> session.update(input.set(image, WIDTH, 1, last)));
    assertThrows(
        TimestampOrderException.class, () -> session.update(input.set(image, WIDTH, 1, -1)));
    assertEquals(last, frame.getTimestamp());
    assertEquals(TrackingState.TRACKING, frame.getCamera().getTrackingState());
  }

  /** As the android package makes one. */
  private static final class AnyBuffer extends CameraInput.Hardware {
    AnyBuffer(Object buffer, long timestampNs) {
      super(WIDTH, HEIGHT);
      setBuffer(buffer, null, timestampNs);
    }
  }

  @Test
  @DisplayName("textures and hardware buffers are refused where there is no GPU")
  void gpuInputs() {
    long next = sequence.references.get(FED).timestampNs();
    CameraInput.Texture texture = new CameraInput.Texture(WIDTH, HEIGHT);
    CameraInput.ExternalTexture external = new CameraInput.ExternalTexture(WIDTH, HEIGHT);
    assertRefused(() -> texture.set(1, new float[15], next));
    assertThrows(GlideException.class, () -> session.update(texture.set(1, null, next)));
    assertThrows(
        GlideException.class, () -> session.update(external.set(1, new float[16], next)));
    assertRefused(() -> session.update(new AnyBuffer(null, next)));
    assertThrows(
        UnsupportedConfigurationException.class,
        () -> session.update(new AnyBuffer("no buffer", next)));
    assertEquals(TrackingState.TRACKING, feedNext().getCamera().getTrackingState());
  }

  @Test
  @DisplayName("a misspelt setting is refused with the likely one")
  void settings() {
    Config config = sequence.config().set("initialization.min_matchs", "60");
    String message =
        assertThrows(InvalidArgumentException.class, () -> new Session(config)).getMessage();
    assertTrue(message.contains("initialization.min_matches"), message);
    assertRefused(() -> new Session(sequence.config().set("initialization.min_matches", "x")));
    assertRefused(() -> new Session(null));
    new Session(sequence.config().set("initialization.min_matches", "61")).close();
  }

  @Test
  @DisplayName("matrices need room for sixteen numbers")
  void matrices() {
    Camera camera = frame.getCamera();
    assertRefused(() -> camera.getViewMatrix(null, 0));
    assertRefused(() -> camera.getViewMatrix(new float[15], 0));
    assertRefused(() -> camera.getViewMatrix(new float[20], 5));
    assertRefused(() -> camera.getViewMatrix(new float[20], -1));
    assertRefused(() -> camera.getProjectionMatrix(new float[20], Integer.MAX_VALUE, 1, 2));
  }

  @Test
  @DisplayName("native methods check every buffer and handle that they are given")
  void nativeChecks() {
    long handle = session.handle();
    ByteBuffer answer = Layout.struct(Layout.FRAME_SIZE);
    ByteBuffer pixels = sequence.image(FED);
    ByteBuffer image = input.set(pixels, WIDTH, 1, 1L << 60).struct;
    ByteBuffer small = Layout.struct(Layout.FRAME_SIZE - 8);
    ByteBuffer heap = ByteBuffer.allocate(Layout.FRAME_SIZE).order(ByteOrder.nativeOrder());
    assertRefused(() -> Native.update(handle, null, pixels, null, answer));
    assertRefused(() -> Native.update(handle, image, null, null, answer));
    assertRefused(() -> Native.update(handle, image, pixels, null, null));
    assertRefused(() -> Native.update(handle, image, pixels, null, small));
    assertRefused(() -> Native.update(handle, image, pixels, null, heap));
    assertRefused(() -> Native.update(handle, image, ByteBuffer.allocate(SIZE), null, answer));
    image.putLong(Layout.IMAGE_PIXELS, 1);
    assertRefused(() -> Native.update(handle, image, pixels, null, answer));
    image.putLong(Layout.IMAGE_PIXELS, -8);
    assertRefused(() -> Native.update(handle, image, pixels, null, answer));
    image.putLong(Layout.IMAGE_PIXELS, 0).putLong(Layout.IMAGE_ROW_STRIDE, Long.MAX_VALUE);
    assertRefused(() -> Native.update(handle, image, pixels, null, answer));
    assertRefused(() -> Native.create(small, new byte[0]));
    assertRefused(() -> Native.create(sequence.config().struct(), null));
    assertRefused(() -> Native.createAnchor(handle, ByteBuffer.allocateDirect(8)));
    assertRefused(() -> Native.pushImu(handle, null));
    assertRefused(() -> Native.saveMap(handle, null));
    assertRefused(() -> Native.loadMapBytes(handle, null));
    assertRefused(() -> Native.pointCloud(handle, heap));
    assertRefused(() -> Native.trackedPoints(handle, heap));
    assertRefused(() -> Native.anchor(handle, 12345, Layout.struct(Layout.ANCHOR_SIZE)));
    for (long stale : new long[] {0, 1, -1, handle + 8, Long.MIN_VALUE}) {
      assertThrows(SessionClosedException.class, () -> Native.pause(stale));
      assertThrows(SessionClosedException.class, () -> Native.mapRevision(stale));
      Native.destroy(stale);
      Native.releaseMap(stale);
    }
    assertEquals(TrackingState.TRACKING, feedNext().getCamera().getTrackingState());
  }
}
