package io.github.glideslam.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assume.assumeTrue;

import android.opengl.Matrix;
import io.github.glideslam.CameraInput;
import io.github.glideslam.CameraIntrinsics;
import io.github.glideslam.Frame;
import io.github.glideslam.Session;
import java.io.File;
import java.nio.ByteBuffer;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.annotation.Config;

/** What DisplayTransform says about a tap is what the library's matrices draw there. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34, manifest = Config.NONE)
public final class DisplayMatricesTest {
  private static final int WIDTH = 64;
  private static final int HEIGHT = 48;
  private static final float FX = 50;
  private static final float FY = 55;
  private static final float CX = 30;
  private static final float CY = 25;
  private static final int VIEW_WIDTH = 108;
  private static final int VIEW_HEIGHT = 234;
  private static final float PIXELS = 1e-3f;

  private final float[] clipFromWorld = new float[16];

  @Before
  public void findLibrary() {
    File library = new File(
        System.getProperty("java.library.path"), System.mapLibraryName("glide_jni"));
    assumeTrue(library + " was not built", library.exists());
  }

  /** A frame without a map: the camera is the world. */
  private static Frame blankFrame(Session session) {
    ByteBuffer pixels = ByteBuffer.allocateDirect(WIDTH * HEIGHT);
    return session.update(new CameraInput.Luma(WIDTH, HEIGHT).set(pixels, WIDTH, 1, 1));
  }

  private void readMatrices(Frame frame) {
    float[] view = new float[16];
    float[] projection = new float[16];
    frame.getCamera().getViewMatrix(view, 0);
    frame.getCamera().getProjectionMatrix(projection, 0, 0.1f, 100);
    Matrix.multiplyMM(clipFromWorld, 0, projection, 0, view, 0);
  }

  /** Where a pixel's ray is drawn in the view, pixels from the upper left. */
  private float[] drawn(float u, float v) {
    float[] ray = {(u - CX) / FX, (CY - v) / FY, -1, 1};
    float[] clip = new float[4];
    Matrix.multiplyMV(clip, 0, clipFromWorld, 0, ray, 0);
    float x = (clip[0] / clip[3] + 1) / 2 * VIEW_WIDTH;
    float y = (1 - clip[1] / clip[3]) / 2 * VIEW_HEIGHT;
    return new float[] {x, y};
  }

  @Test
  public void aTapMeetsWhatIsDrawnThereHoweverTheDisplayIsTurned() {
    CameraIntrinsics camera = new CameraIntrinsics(WIDTH, HEIGHT, FX, FY, CX, CY);
    io.github.glideslam.Config config = new io.github.glideslam.Config(camera)
        .setBackend(io.github.glideslam.Config.Backend.CPU);
    try (Session session = new Session(config)) {
      Frame frame = blankFrame(session);
      for (int rotation = 0; rotation < 360; rotation += 90) {
        session.setDisplayGeometry(rotation, VIEW_WIDTH, VIEW_HEIGHT);
        readMatrices(frame);
        DisplayTransform transform =
            new DisplayTransform(WIDTH, HEIGHT, rotation, VIEW_WIDTH, VIEW_HEIGHT);
        float[] tap = drawn(17, 31);
        float[] pixel = new float[2];
        transform.viewToImage(tap[0], tap[1], pixel);
        assertEquals("u at " + rotation, 17, pixel[0], PIXELS);
        assertEquals("v at " + rotation, 31, pixel[1], PIXELS);
        transform.imageToView(17, 31, pixel);
        assertArrayEquals("view at " + rotation, tap, pixel, PIXELS);
      }
    }
  }
}
