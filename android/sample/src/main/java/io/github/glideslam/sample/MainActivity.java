package io.github.glideslam.sample;

import android.Manifest;
import android.app.Activity;
import android.content.pm.PackageManager;
import android.opengl.GLSurfaceView;
import android.os.Bundle;
import android.view.MotionEvent;
import android.view.WindowManager;
import io.github.glideslam.GlideException;
import io.github.glideslam.android.Camera2Source;
import java.io.File;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Tracks the camera on the back; a tap places a cube. */
public final class MainActivity extends Activity {
  private static final int CAMERA_REQUEST = 1;
  private static final int GLES_3 = 3;

  private final ExecutorService background = Executors.newSingleThreadExecutor();
  private final ArRenderer renderer = new ArRenderer(this::show);
  private GLSurfaceView glView;
  private Controls controls;
  private DisplayRotation rotation;
  private ArSession ar;
  private boolean wasAsked;

  @Override
  protected void onCreate(Bundle savedState) {
    super.onCreate(savedState);
    getWindow().addFlags(WindowManager.LayoutParams.FLAG_KEEP_SCREEN_ON);
    glView = new GLSurfaceView(this);
    glView.setEGLContextClientVersion(GLES_3);
    glView.setPreserveEGLContextOnPause(true); // where the device can; else onSurfaceCreated comes again
    glView.setRenderer(renderer);
    glView.setOnTouchListener((view, event) -> onTouch(event));
    controls = new Controls(this, glView);
    controls.addButton("Save map", () -> withMap("Saved", path -> ar.session.saveMap(path)));
    controls.addButton("Load map", () -> withMap("Loaded", path -> ar.session.loadMap(path)));
    controls.addButton("Start anew", () -> withMap("Started anew", path -> ar.session.reset()));
    setContentView(controls.getRoot());
    rotation = new DisplayRotation(
        this, degrees -> glView.queueEvent(() -> renderer.setDisplayRotation(degrees)));
  }

  @Override
  protected void onResume() {
    super.onResume();
    glView.onResume();
    rotation.start();
    if (checkSelfPermission(Manifest.permission.CAMERA) == PackageManager.PERMISSION_GRANTED) {
      resumeSession();
    } else if (wasAsked) {
      show("Without the camera there is nothing to see: grant it in the settings");
    } else {
      wasAsked = true; // the answer comes with another onResume
      requestPermissions(new String[] {Manifest.permission.CAMERA}, CAMERA_REQUEST);
    }
  }

  private void resumeSession() {
    try {
      if (ar == null) {
        ar = new ArSession(this, this::onCameraState);
        ArSession made = ar;
        glView.queueEvent(() -> renderer.setSession(made));
      }
      ar.resume();
    } catch (GlideException e) {
      show(e.getMessage());
    }
  }

  @Override
  protected void onPause() {
    rotation.stop();
    if (ar != null) {
      ar.pause(); // the camera is another app's from here on
    }
    glView.onPause();
    super.onPause();
  }

  @Override
  protected void onDestroy() {
    glView.queueEvent(renderer::abandonFrames);
    if (ar != null) {
      background.execute(ar::close); // may take seconds
    }
    background.shutdown();
    super.onDestroy();
  }

  private boolean onTouch(MotionEvent event) {
    if (event.getActionMasked() == MotionEvent.ACTION_DOWN) {
      float x = event.getX();
      float y = event.getY();
      glView.queueEvent(() -> renderer.tap(x, y));
    }
    return true;
  }

  private void onCameraState(Camera2Source.State state, String reason) {
    if (state == Camera2Source.State.FAILED) {
      show(reason);
    }
  }

  private interface MapAction {
    void run(String path);
  }

  private void withMap(String done, MapAction action) {
    if (ar == null) {
      return;
    }
    String path = new File(getFilesDir(), "map.glide").getPath();
    background.execute(() -> {
      try {
        action.run(path);
        show(done);
      } catch (GlideException e) {
        show(e.getMessage());
      }
    });
  }

  /** Any thread. */
  private void show(String text) {
    runOnUiThread(() -> controls.setText(text));
  }
}
