package io.github.glideslam;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Images and the C++ API's poses, as reference_run wrote them. */
final class Sequence {
  /** One line of sequence.txt: {@code pose} is tx ty tz qx qy qz qw. */
  record Reference(long timestampNs, boolean isTracked, double[] pose) {}

  private static final int CAMERA_NUMBERS = 6;

  final CameraIntrinsics camera;
  final List<Reference> references = new ArrayList<>();
  private final Path folder;

  private Sequence(Path folder) throws IOException {
    this.folder = folder;
    List<String> lines = Files.readAllLines(folder.resolve("sequence.txt"));
    camera = camera(numbers(lines.get(0)));
    for (String line : lines.subList(1, lines.size())) {
      double[] n = numbers(line);
      long timestamp = Long.parseLong(line.substring(0, line.indexOf(' ')));
      references.add(new Reference(timestamp, n[1] == 1, tail(n, 2)));
    }
  }

  static boolean exists(String name) {
    return Files.exists(folderOf(name));
  }

  static Sequence open(String name) {
    try {
      return new Sequence(folderOf(name));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The walk along a wall, on the CPU, with mapping inside update: 30 images of 320x240. */
  static Sequence walk() {
    return open("walk");
  }

  /** What reference_run's C++ session was made with. */
  Config config() {
    Config config = new Config(camera).setBackend(Config.Backend.CPU).setDeterministic(true);
    return folder.endsWith("walk") ? config.set("initialization.min_matches", "60") : config;
  }

  int size() {
    return references.size();
  }

  /** Pixels of an image in a direct buffer, rows without gaps. */
  ByteBuffer image(int number) {
    int size = camera.width() * camera.height();
    try {
      byte[] file = Files.readAllBytes(folder.resolve(String.format(Locale.ROOT, "%04d.pgm", number)));
      return ByteBuffer.allocateDirect(size).put(file, file.length - size, size).rewind();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A reused input. */
  CameraInput.Luma input() {
    return new CameraInput.Luma(camera.width(), camera.height());
  }

  /** Feeds frames [begin, end). The last answer. */
  Frame feed(Session session, int begin, int end) {
    CameraInput.Luma input = input();
    Frame frame = null;
    for (int i = begin; i < end; ++i) {
      frame = session.update(
          input.set(image(i), camera.width(), 1, references.get(i).timestampNs()));
    }
    return frame;
  }

  private static Path folderOf(String name) {
    return Paths.get(System.getProperty("glide.sequences", "."), name);
  }

  private static CameraIntrinsics camera(double[] n) {
    return new CameraIntrinsics(
        (int) n[0], (int) n[1], n[2], n[3], n[4], n[5],
        CameraIntrinsics.Distortion.values()[(int) n[CAMERA_NUMBERS]],
        tail(n, CAMERA_NUMBERS + 1));
  }

  private static double[] numbers(String line) {
    String[] words = line.split(" ");
    double[] numbers = new double[words.length];
    for (int i = 0; i < words.length; ++i) {
      numbers[i] = Double.parseDouble(words[i]);
    }
    return numbers;
  }

  private static double[] tail(double[] all, int begin) {
    return java.util.Arrays.copyOfRange(all, begin, all.length);
  }
}
