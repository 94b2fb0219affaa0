package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import io.github.glideslam.CameraIntrinsics.Distortion;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

/** Small values. Pure Java: needs no native library. */
class ValuesTest {
  @Test
  @DisplayName("every status has its exception, which tells the status and the message")
  void exceptions() {
    Map<Integer, Class<? extends GlideException>> expected = Map.ofEntries(
        Map.entry(-1, InvalidArgumentException.class),
        Map.entry(-2, FatalException.class),
        Map.entry(-3, SessionPausedException.class),
        Map.entry(-5, NotTrackingException.class),
        Map.entry(-7, MissingGlContextException.class),
        Map.entry(-8, UnsupportedConfigurationException.class),
        Map.entry(-11, ResourceExhaustedException.class),
        Map.entry(-12, NotYetAvailableException.class),
        Map.entry(-18, DataInvalidFormatException.class),
        Map.entry(-19, DataUnsupportedVersionException.class),
        Map.entry(-100, SessionClosedException.class),
        Map.entry(-101, WrongThreadException.class),
        Map.entry(-102, TimestampOrderException.class),
        Map.entry(-103, MapIoException.class),
        Map.entry(-104, GlException.class),
        Map.entry(-999, GlideException.class));
    expected.forEach((status, type) -> {
      GlideException e = GlideException.of(status, "w\u00e4rum".getBytes(StandardCharsets.UTF_8));
      assertSame(type, e.getClass());
      assertEquals(status, e.getStatus());
      assertEquals("w\u00e4rum", e.getMessage());
      assertInstanceOf(RuntimeException.class, e);
    });
  }

  @Test
  @DisplayName("a message that was cut within a character is still a message")
  void cutMessage() {
    byte[] cut = {'a', (byte) 0xc3};
    assertEquals("a\ufffd", GlideException.of(-1, cut).getMessage());
  }

  @Test
  @DisplayName("intrinsics scale with the image, about pixels' borders")
  void scaledIntrinsics() {
    CameraIntrinsics half = new CameraIntrinsics(640, 480, 500, 510, 319.5, 239.5).scaledTo(320);
    assertArrayEquals(new int[] {320, 240}, half.getImageDimensions());
    assertArrayEquals(new float[] {250, 255}, half.getFocalLength());
    assertArrayEquals(new float[] {159.5f, 119.5f}, half.getPrincipalPoint());
  }

  @Test
  @DisplayName("intrinsics come back from a struct as they were")
  void intrinsicsInStruct() {
    CameraIntrinsics given = new CameraIntrinsics(
        640, 480, 500, 510, 319.5, 239.5, Distortion.KANNALA_BRANDT4, 0.1, 0.2, 0.3, 0.4);
    java.nio.ByteBuffer struct = Layout.array(1, Layout.CAMERA_SIZE);
    given.write(struct, 0);
    CameraIntrinsics read = CameraIntrinsics.read(struct);
    assertArrayEquals(given.getImageDimensions(), read.getImageDimensions());
    assertArrayEquals(given.getFocalLength(), read.getFocalLength());
    assertArrayEquals(given.getPrincipalPoint(), read.getPrincipalPoint());
    assertEquals(given.getDistortion(), read.getDistortion());
    assertArrayEquals(given.getCoefficients(), read.getCoefficients());
  }

  @Test
  @DisplayName("intrinsics keep a copy of their coefficients, and refuse too many")
  void coefficients() {
    double[] given = {0.1, 0.2, 0, 0};
    CameraIntrinsics camera =
        new CameraIntrinsics(4, 3, 5, 5, 2, 1, Distortion.RADIAL_TANGENTIAL, given);
    given[0] = 9;
    camera.getCoefficients()[1] = 9;
    assertArrayEquals(new double[] {0.1, 0.2, 0, 0}, camera.getCoefficients());
    assertEquals(Distortion.RADIAL_TANGENTIAL, camera.getDistortion());
    assertThrows(
        InvalidArgumentException.class,
        () -> new CameraIntrinsics(4, 3, 5, 5, 2, 1, Distortion.NONE, new double[9]));
    assertThrows(
        InvalidArgumentException.class, () -> new CameraIntrinsics(4, 3, 5, 5, 2, 1, null));
  }

  @Test
  @DisplayName("a config refuses null and zeros, at the call that gave them")
  void configs() {
    Config config = new Config(new CameraIntrinsics(4, 3, 5, 5, 2, 1));
    assertThrows(InvalidArgumentException.class, () -> new Config((CameraIntrinsics) null));
    assertThrows(InvalidArgumentException.class, () -> config.setBackend(null));
    assertThrows(InvalidArgumentException.class, () -> config.setMode(null));
    assertThrows(InvalidArgumentException.class, () -> config.set("name", null));
    assertThrows(InvalidArgumentException.class, () -> config.set("na\0me", "1"));
  }

  @Test
  @DisplayName("every reason of the library has its own")
  void reasons() {
    assertSame(TrackingFailureReason.NONE, TrackingFailureReason.of(0));
    assertSame(TrackingFailureReason.INSUFFICIENT_FEATURES, TrackingFailureReason.of(1));
    assertSame(TrackingFailureReason.EXCESSIVE_MOTION, TrackingFailureReason.of(2));
    assertSame(TrackingFailureReason.INSUFFICIENT_PARALLAX, TrackingFailureReason.of(3));
    assertSame(TrackingFailureReason.AMBIGUOUS, TrackingFailureReason.of(4));
    assertSame(TrackingFailureReason.RELOCALIZING, TrackingFailureReason.of(5));
    assertSame(TrackingFailureReason.BAD_STATE, TrackingFailureReason.of(77));
  }
}
