package io.github.glideslam.android;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import android.content.Context;
import android.graphics.SurfaceTexture;
import android.hardware.camera2.CameraManager;
import android.util.Size;
import android.view.Surface;
import io.github.glideslam.CameraInput;
import io.github.glideslam.UnsupportedConfigurationException;
import io.github.glideslam.android.Camera2Source.State;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowCameraManager;

@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34, manifest = Config.NONE)
public final class Camera2SourceTest {
  private final List<State> states = Collections.synchronizedList(new ArrayList<>());
  private final List<String> reasons = Collections.synchronizedList(new ArrayList<>());
  private Context context;
  private CameraManager manager;
  private Camera2Source source;
  private Surface surface;

  @Before
  public void setUp() {
    context = RuntimeEnvironment.getApplication();
    manager = (CameraManager) context.getSystemService(Context.CAMERA_SERVICE);
    surface = new Surface(new SurfaceTexture(0));
  }

  @After
  public void tearDown() {
    if (source != null) {
      source.close();
    }
    surface.release();
  }

  private ShadowCameraManager cameras() {
    return Shadow.extract(manager);
  }

  private void make(PhoneCamera camera) {
    make(camera, (state, reason) -> {
      states.add(state);
      reasons.add(reason);
    });
  }

  private void make(PhoneCamera camera, Camera2Source.Listener listener) {
    cameras().addCamera("0", camera.characteristics());
    source = new Camera2Source(context, new Size(640, 480), listener);
  }

  @Test
  public void opensConfiguresRunsAndStops() {
    make(new PhoneCamera());
    assertEquals(State.STOPPED, source.getState());
    source.start(surface);
    CameraThread.settle();
    assertEquals(State.RUNNING, source.getState());
    source.stop();
    source.stop();
    source.close();
    source.close();
    assertEquals(
        Arrays.asList(
            State.OPENING, State.CONFIGURING, State.RUNNING, State.STOPPED, State.CLOSED),
        states);
  }

  @Test
  public void aCameraThatIsTakenAwayFailsAndCanBeStartedAgain() {
    make(new PhoneCamera());
    source.start(surface);
    CameraThread.settle();
    cameras().triggerDisconnect();
    CameraThread.settle();
    assertEquals(State.FAILED, source.getState());
    assertEquals("the camera was taken by another app", reasons.get(reasons.size() - 1));
    source.start(surface);
    CameraThread.settle();
    assertEquals(State.RUNNING, source.getState());
  }

  @Test
  public void openingACameraThatIsGoneFailsWithAReason() {
    make(new PhoneCamera());
    cameras().removeCamera("0");
    source.start(surface);
    CameraThread.settle();
    assertEquals(State.FAILED, source.getState());
    assertTrue(reasons.toString(), reasons.get(reasons.size() - 1).contains("does not open"));
  }

  @Test
  public void stopWhileTheCameraOpensWins() {
    make(new PhoneCamera());
    source.start(surface);
    source.stop();
    CameraThread.settle();
    assertEquals(State.STOPPED, source.getState());
    // How far the camera's thread came before is its affair; after the stop it says nothing more.
    assertEquals(State.OPENING, states.get(0));
    assertEquals(states.toString(), states.size() - 1, states.indexOf(State.STOPPED));
  }

  @Test
  public void aStopWhileTheListenerIsToldSomethingIsToldAfterIt() throws InterruptedException {
    CountDownLatch isTelling = new CountDownLatch(1);
    CountDownLatch isStopped = new CountDownLatch(1);
    make(new PhoneCamera(), (state, reason) -> {
      if (state == State.CONFIGURING) {
        isTelling.countDown();
        await(isStopped);
      }
      states.add(state);
    });
    source.start(surface);
    assertTrue(isTelling.await(10, TimeUnit.SECONDS));
    source.stop();
    isStopped.countDown();
    CameraThread.settle();
    assertEquals(Arrays.asList(State.OPENING, State.CONFIGURING, State.STOPPED), states);
  }

  private static void await(CountDownLatch latch) {
    try {
      assertTrue(latch.await(10, TimeUnit.SECONDS));
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  public void aListenerMayStartAndStop() {
    make(new PhoneCamera(), (state, reason) -> {
      states.add(state);
      if (state == State.RUNNING) {
        source.stop();
        assertEquals("one at a time", State.RUNNING, states.get(states.size() - 1));
      }
    });
    source.start(surface);
    CameraThread.settle();
    assertEquals(
        Arrays.asList(State.OPENING, State.CONFIGURING, State.RUNNING, State.STOPPED), states);
  }

  @Test
  public void closeWhileTheCameraOpensEndsTheThreadToo() throws InterruptedException {
    make(new PhoneCamera());
    source.start(surface);
    source.close();
    for (Thread thread : CameraThread.alive()) {
      thread.join(10_000);
      assertFalse(thread.isAlive());
    }
    assertEquals(State.CLOSED, source.getState());
  }

  @Test
  public void aSecondStartTakesTheOtherSurface() {
    make(new PhoneCamera());
    source.start(surface);
    CameraThread.settle();
    Surface other = new Surface(new SurfaceTexture(1));
    source.start(other);
    CameraThread.settle();
    assertEquals(State.RUNNING, source.getState());
    assertEquals(6, states.size());
    source.stop();
    other.release();
  }

  @Test
  public void aClosedSourceIsNotStarted() {
    make(new PhoneCamera());
    source.close();
    assertThrows(IllegalStateException.class, () -> source.start(surface));
  }

  @Test
  public void tellsSizeCalibrationAndOrientation() {
    make(new PhoneCamera().calibrated());
    assertEquals(new Size(640, 480), source.getSize());
    assertEquals(90, source.getSensorOrientation());
    assertFalse(source.getCalibration().isEstimated());
    assertEquals(512, source.getCalibration().getIntrinsics().getFocalLength()[0], 1e-3);
    assertTrue(source.isClockShared());
    assertFalse(source.isLensMoving());
  }

  @Test
  public void aCameraWithoutCalibrationIsEstimated() {
    make(new PhoneCamera());
    assertTrue(source.getCalibration().isEstimated());
  }

  @Test
  public void framesGetTheMiddleOfTheirExposure() {
    make(new PhoneCamera());
    CameraInput.ExternalTexture input = new CameraInput.ExternalTexture(640, 480);
    source.stamp(input, 1234, new FrameTimings.Timing());
    assertEquals(1234, input.getTimestamp());
  }

  @Test
  public void withoutACameraOnTheBackThereIsNoSource() {
    assertThrows(
        UnsupportedConfigurationException.class,
        () -> new Camera2Source(context, new Size(640, 480), null));
  }
}
