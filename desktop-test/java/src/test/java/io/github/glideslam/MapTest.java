package io.github.glideslam;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

class MapTest extends TrackedTest {
  @Test
  @DisplayName("a snapshot has all points and keyframes, and outlives its session")
  void snapshot() {
    try (MapSnapshot map = session.acquireMap()) {
      session.close();
      assertTrue(map.getRevision() > 0);
      try (PointCloud points = map.getPoints()) {
        assertTrue(points.size() > 20);
      }
      List<MapSnapshot.Keyframe> keyframes = map.getKeyframes();
      assertTrue(keyframes.size() >= 2);
      for (int i = 0; i < keyframes.size(); ++i) {
        assertTrue(keyframes.get(i).getTimestamp() > 0);
        assertTrue(i == 0 || keyframes.get(i).getId() > keyframes.get(i - 1).getId());
      }
      assertArrayEquals(new float[3], keyframes.get(0).getPose().getTranslation(), 1e-6f);
      assertEquals(
          keyframes.size(), keyframes.stream().filter(keyframe -> !keyframe.isRetired()).count());
    }
  }

  @Test
  @DisplayName("a short walk closes no loop and corrects no camera")
  void loops() {
    session.waitForMapping();
    try (MapSnapshot map = session.acquireMap()) {
      assertTrue(map.getLoops().isEmpty());
      assertThrows(NotYetAvailableException.class, map::getCorrectedCamera);
    }
  }

  @Test
  @DisplayName("a closed snapshot refuses every question")
  void closedSnapshot() {
    MapSnapshot map = session.acquireMap();
    map.close();
    map.close();
    for (Executable question :
        List.<Executable>of(
            map::getRevision, map::getGeneration, map::getPoints, map::getKeyframes, map::getLoops,
            map::getCorrectedCamera)) {
      assertEquals(
          "the map snapshot is closed",
          assertThrows(SessionClosedException.class, question).getMessage());
    }
  }

  @Test
  @DisplayName("the frame's map is the one that the frame was tracked in, the newest may be newer")
  void frameMap() {
    boolean wasNewer = false;
    for (int i = FED; i < sequence.size(); ++i) {
      sequence.feed(session, i, i + 1);
      try (MapSnapshot newest = session.acquireMap();
          MapSnapshot map = session.acquireFrameMap()) {
        assertEquals(frame.getMapRevision(), map.getRevision());
        assertEquals(frame.getMapGeneration(), map.getGeneration());
        assertEquals(frame.getMapGeneration(), newest.getGeneration());
        wasNewer |= newest.getRevision() > map.getRevision();
      }
    }
    assertTrue(wasNewer);
  }

  @Test
  @DisplayName("a new map is of another generation than the one that a reset dropped")
  void generations() {
    long before = frame.getMapGeneration();
    try (MapSnapshot old = session.acquireFrameMap()) {
      session.reset();
      try (MapSnapshot none = session.acquireFrameMap()) {
        assertEquals(0, none.getPoints().size());
      }
      sequence.feed(session, FED, sequence.size());
      assertEquals(TrackingState.TRACKING, frame.getCamera().getTrackingState());
      assertTrue(frame.getMapGeneration() > before);
      try (MapSnapshot map = session.acquireFrameMap()) {
        assertEquals(frame.getMapGeneration(), map.getGeneration());
      }
      assertEquals(before, old.getGeneration());
    }
  }

  @Test
  @DisplayName("a map that was saved to a file is recognised in another session")
  void files(@TempDir Path folder) {
    String path = folder.resolve("w\u00e4nde \ud83d\ude00.map").toString();
    session.saveMap(path);
    assertTrue(Files.exists(Path.of(path)), "the name is UTF-8");
    try (Session other = new Session(sequence.config())) {
      other.loadMap(path);
      Frame found = sequence.feed(other, 9, 13);
      assertEquals(TrackingState.TRACKING, found.getCamera().getTrackingState());
      assertEquals(
          session.locate(found.getTimestamp()).getPose().tx(), found.getCamera().getPose().tx(), 0.02);
    }
  }

  @Test
  @DisplayName("streams carry the same bytes as files")
  void streams(@TempDir Path folder) throws IOException {
    Path path = folder.resolve("map");
    session.saveMap(path.toString());
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    session.saveMap(stream);
    assertArrayEquals(Files.readAllBytes(path), stream.toByteArray());
    try (Session other = new Session(sequence.config());
        InputStream in = new ByteArrayInputStream(stream.toByteArray())) {
      other.loadMap(in);
      try (MapSnapshot mine = session.acquireMap();
          MapSnapshot theirs = other.acquireMap()) {
        assertEquals(mine.getPoints().size(), theirs.getPoints().size());
      }
    }
  }

  @Test
  @DisplayName("what is no map, or another camera's, is refused and changes nothing")
  void broken() {
    ByteArrayOutputStream stream = new ByteArrayOutputStream();
    session.saveMap(stream);
    byte[] map = stream.toByteArray();
    byte[] half = Arrays.copyOf(map, map.length / 2);
    for (byte[] bytes : List.of(new byte[0], new byte[] {1, 2, 3}, half)) {
      assertThrows(
          DataInvalidFormatException.class,
          () -> session.loadMap(new ByteArrayInputStream(bytes)));
    }
    CameraIntrinsics other = sequence.camera.scaledTo(640);
    try (Session wide = new Session(new Config(other).setBackend(Config.Backend.CPU))) {
      assertThrows(
          InvalidArgumentException.class, () -> wide.loadMap(new ByteArrayInputStream(map)));
    }
    assertEquals(TrackingState.TRACKING, feedNext().getCamera().getTrackingState());
  }

  @Test
  @DisplayName("files and streams that fail are told apart from maps that are broken")
  void failing(@TempDir Path folder) {
    String nowhere = folder.resolve("no/such/folder").toString();
    assertThrows(MapIoException.class, () -> session.saveMap(nowhere));
    assertThrows(MapIoException.class, () -> session.loadMap(nowhere));
    IOException full = new IOException("full");
    OutputStream out = new OutputStream() {
      @Override
      public void write(int value) throws IOException {
        throw full;
      }
    };
    InputStream in = new InputStream() {
      @Override
      public int read() throws IOException {
        throw full;
      }
    };
    assertSame(full, assertThrows(MapIoException.class, () -> session.saveMap(out)).getCause());
    assertSame(full, assertThrows(MapIoException.class, () -> session.loadMap(in)).getCause());
    assertThrows(InvalidArgumentException.class, () -> session.saveMap((String) null));
    assertThrows(InvalidArgumentException.class, () -> session.loadMap((InputStream) null));
    assertThrows(InvalidArgumentException.class, () -> session.saveMap((OutputStream) null));
    assertThrows(InvalidArgumentException.class, () -> session.saveMap("a\0b"));
  }
}
