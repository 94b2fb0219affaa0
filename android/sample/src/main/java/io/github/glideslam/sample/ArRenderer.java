package io.github.glideslam.sample;

import android.opengl.GLES20;
import android.opengl.GLSurfaceView;
import android.opengl.Matrix;
import io.github.glideslam.Camera;
import io.github.glideslam.CameraInput;
import io.github.glideslam.Frame;
import io.github.glideslam.GlideException;
import io.github.glideslam.TrackingState;
import io.github.glideslam.android.DisplayTransform;
import io.github.glideslam.android.TextureFrames;
import javax.microedition.khronos.egl.EGLConfig;
import javax.microedition.khronos.opengles.GL10;

/** Tracks, and draws what is tracked. Everything on the GL thread. */
final class ArRenderer implements GLSurfaceView.Renderer {
  /** Told on the GL thread. */
  interface Status {
    void show(String text);
  }

  // Scene units: the first keyframes' median depth is about 1.
  private static final float NEAR = 0.01f;
  private static final float FAR = 100;
  private static final int FRAMES_PER_TEXT = 10;

  private final Status status;
  private final float[] view = new float[16];
  private final float[] projection = new float[16];
  private final float[] clipFromWorld = new float[16];
  private ArSession ar;
  private TextureFrames frames;
  private CameraBackground background;
  private PointOverlay points;
  private Cube cube;
  private PlacedCubes cubes = new PlacedCubes();
  private DisplayTransform transform;
  private Frame frame;
  private int width;
  private int height;
  private int displayRotation;
  private int untilText;

  ArRenderer(Status status) {
    this.status = status;
  }

  /** Once there is one; by queueEvent. */
  void setSession(ArSession session) {
    ar = session;
    openFrames();
    place();
  }

  /** Degrees; by queueEvent. */
  void setDisplayRotation(int degrees) {
    displayRotation = degrees;
    place();
  }

  /** A tap, in pixels of the view; by queueEvent. */
  void tap(float x, float y) {
    if (!isTracking() || transform == null) {
      return;
    }
    float[] pixel = new float[2];
    transform.viewToImage(x, y, pixel);
    guarded(() -> {
      if (!cubes.place(frame, pixel)) {
        status.show("Nothing to stand on there");
        untilText = FRAMES_PER_TEXT;
      }
    });
  }

  /** Also called when the context was lost: everything that was GL's is gone, the map is not. */
  @Override
  public void onSurfaceCreated(GL10 gl, EGLConfig config) {
    if (ar != null) {
      guarded(ar.session::abandonGl);
    }
    abandonFrames();
    background = new CameraBackground();
    points = new PointOverlay();
    cube = new Cube();
    openFrames();
  }

  @Override
  public void onSurfaceChanged(GL10 gl, int newWidth, int newHeight) {
    width = newWidth;
    height = newHeight;
    GLES20.glViewport(0, 0, width, height);
    place();
  }

  @Override
  public void onDrawFrame(GL10 gl) {
    GLES20.glClear(GLES20.GL_COLOR_BUFFER_BIT | GLES20.GL_DEPTH_BUFFER_BIT);
    if (frames == null) {
      return;
    }
    guarded(this::track);
    background.draw(frames.getTextureName());
    if (isTracking()) {
      guarded(this::drawScene);
    }
  }

  /** When the context is gone, or goes with the view; by queueEvent. */
  void abandonFrames() {
    if (frames != null) {
      ar.setSurface(null);
      frames.abandon();
      frames = null;
    }
  }

  /** As soon as there are a session and a context, in whatever order they come. */
  private void openFrames() {
    if (ar != null && background != null && frames == null) {
      frames = new TextureFrames(ar.camera);
      ar.setSurface(frames.getSurface());
    }
  }

  /** How the image lies in the view. */
  private void place() {
    if (ar == null || width == 0) {
      return;
    }
    int rotation =
        DisplayTransform.imageRotation(ar.camera.getSensorOrientation(), displayRotation);
    guarded(() -> ar.session.setDisplayGeometry(rotation, width, height));
    transform = new DisplayTransform(
        ar.camera.getSize().getWidth(), ar.camera.getSize().getHeight(), rotation, width, height);
    background.setTransform(transform);
  }

  private void track() {
    CameraInput input = frames.acquire();
    if (input == null) {
      return;
    }
    frame = ar.session.update(input);
    if (--untilText <= 0) {
      untilText = FRAMES_PER_TEXT;
      status.show(StateText.of(frame));
    }
  }

  private boolean isTracking() {
    return frame != null && frame.getCamera().getTrackingState() == TrackingState.TRACKING;
  }

  private void drawScene() {
    Camera camera = frame.getCamera();
    camera.getViewMatrix(view, 0);
    camera.getProjectionMatrix(projection, 0, NEAR, FAR);
    Matrix.multiplyMM(clipFromWorld, 0, projection, 0, view, 0);
    points.draw(frame.getTrackedPoints(), transform, width, height);
    cubes.draw(cube, clipFromWorld);
  }

  /** The main thread may pause or close the session at any time: that is no reason to crash. */
  private void guarded(Runnable step) {
    try {
      step.run();
    } catch (GlideException e) {
      status.show(e.getMessage());
    }
  }
}
