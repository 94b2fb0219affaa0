package io.github.glideslam.sample;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;
import static org.junit.Assume.assumeTrue;

import android.Manifest;
import android.app.Application;
import android.content.Context;
import android.hardware.camera2.CameraCharacteristics;
import android.hardware.camera2.CameraManager;
import io.github.glideslam.InvalidArgumentException;
import io.github.glideslam.android.Camera2Source.State;
import io.github.glideslam.android.CameraThread;
import io.github.glideslam.android.PhoneCamera;
import java.io.File;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.Robolectric;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.RuntimeEnvironment;
import org.robolectric.android.controller.ActivityController;
import org.robolectric.annotation.Config;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowActivity;
import org.robolectric.shadows.ShadowApplication;
import org.robolectric.shadows.ShadowCameraManager;

/** The sample with the real library of the desktop, a phone's camera that gives no images, and no GL. */
@RunWith(RobolectricTestRunner.class)
@Config(sdk = 34, manifest = Config.NONE)
public final class SampleLifeTest {
  private final List<State> states = Collections.synchronizedList(new ArrayList<>());
  private final List<String> texts = Collections.synchronizedList(new ArrayList<>());
  private Application app;
  private ArSession ar;
  private ArRenderer renderer;

  @Before
  public void setUp() {
    File library = new File(
        System.getProperty("java.library.path"), System.mapLibraryName("glide_jni"));
    assumeTrue(library + " was not built", library.exists());
    app = RuntimeEnvironment.getApplication();
    ShadowCameraManager cameras =
        Shadow.extract((CameraManager) app.getSystemService(Context.CAMERA_SERVICE));
    cameras.addCamera("0", new PhoneCamera().characteristics());
  }

  @After
  public void tearDown() {
    if (ar != null) {
      renderer.abandonFrames();
      ar.close();
    }
  }

  private void makeRenderer() {
    ar = new ArSession(app, (state, reason) -> states.add(state));
    renderer = new ArRenderer(texts::add);
    renderer.setSession(ar);
  }

  private State settled() {
    CameraThread.settle();
    return ar.camera.getState();
  }

  @Test
  public void theCameraRunsWhileThereAreBothASurfaceAndAResumedActivity() {
    makeRenderer();
    ar.resume();
    assertEquals(State.STOPPED, ar.camera.getState());
    renderer.onSurfaceCreated(null, null);
    renderer.onSurfaceChanged(null, 480, 640);
    assertEquals(State.RUNNING, settled());
    renderer.onDrawFrame(null);
    ar.pause();
    assertEquals(State.STOPPED, ar.camera.getState());
    ar.resume();
    assertEquals(State.RUNNING, settled());
  }

  @Test
  public void aLostContextStartsTheCameraWithANewSurface() {
    makeRenderer();
    ar.resume();
    renderer.onSurfaceCreated(null, null);
    assertEquals(State.RUNNING, settled());
    states.clear();
    renderer.onSurfaceCreated(null, null);
    renderer.onSurfaceChanged(null, 640, 480);
    assertEquals(State.RUNNING, settled());
    assertEquals(State.STOPPED, states.get(0));
    assertTrue(states.contains(State.OPENING));
    renderer.onDrawFrame(null);
    renderer.tap(1, 1);
    assertEquals(Collections.emptyList(), texts);
  }

  @Test
  public void aSurfaceThatComesWhilePausedWaits() {
    makeRenderer();
    renderer.onSurfaceCreated(null, null);
    assertEquals(Collections.emptyList(), states);
  }

  @Test
  public void whatTheViewStillDoesAfterTheEndIsNoReasonToCrash() {
    makeRenderer();
    ar.resume();
    renderer.onSurfaceCreated(null, null);
    assertEquals(State.RUNNING, settled());
    ar.close();
    renderer.onSurfaceCreated(null, null);
    renderer.onSurfaceChanged(null, 640, 480);
    renderer.setDisplayRotation(90);
    renderer.onDrawFrame(null);
    assertTrue(texts.contains("the session is closed"));
    ar.close();
  }

  @Test
  public void aCameraWhoseSessionIsRefusedEndsItsThread() throws InterruptedException {
    float[] broken = {Float.NaN, 0, 0, 0, 0};
    PhoneCamera camera =
        new PhoneCamera().calibrated().with(CameraCharacteristics.LENS_DISTORTION, broken);
    ShadowCameraManager cameras =
        Shadow.extract((CameraManager) app.getSystemService(Context.CAMERA_SERVICE));
    cameras.removeCamera("0");
    cameras.addCamera("0", camera.characteristics());
    Set<Thread> others = CameraThread.alive();
    assertThrows(InvalidArgumentException.class, () -> new ArSession(app, null));
    Set<Thread> left = CameraThread.alive();
    left.removeAll(others);
    for (Thread thread : left) {
      thread.join(10_000);
      assertFalse(thread.isAlive());
    }
  }

  @Test
  public void thePermissionIsAskedForOnce() {
    ActivityController<MainActivity> activity = Robolectric.buildActivity(MainActivity.class);
    activity.setup();
    ShadowActivity shadow = Shadow.extract(activity.get());
    String[] asked = shadow.getLastRequestedPermission().requestedPermissions;
    assertEquals(Manifest.permission.CAMERA, asked[0]);
    activity.pause().resume().pause().stop().destroy();
  }

  @Test
  public void anActivityWithPermissionLivesAndEnds() {
    ShadowApplication shadow = Shadow.extract(app);
    shadow.grantPermissions(Manifest.permission.CAMERA);
    ActivityController<MainActivity> activity = Robolectric.buildActivity(MainActivity.class);
    activity.setup();
    ShadowActivity asked = Shadow.extract(activity.get());
    assertNull(asked.getLastRequestedPermission());
    activity.pause().resume().pause().stop().destroy();
    assertTrue(activity.get().isDestroyed());
  }
}
