package io.github.glideslam.sample;

import android.content.Context;
import android.util.Size;
import android.view.Surface;
import io.github.glideslam.Config;
import io.github.glideslam.Session;
import io.github.glideslam.android.Camera2Source;

/**
 * A session and the camera that it tracks. The camera runs while there is both a surface, which the
 * GL thread brings, and a resumed activity, whichever comes first. Any thread.
 */
final class ArSession implements AutoCloseable {
  // Enough for tracking, and every device offers it.
  private static final Size WANTED = new Size(640, 480);

  final Camera2Source camera;
  final Session session;
  private Surface surface;
  private boolean isResumed;
  private boolean isClosed;

  /** After the permission was granted: without it Android hides the calibration. */
  ArSession(Context context, Camera2Source.Listener listener) {
    camera = new Camera2Source(context, WANTED, listener);
    try {
      Config config = new Config(camera.getCalibration().getIntrinsics());
      config.setGlCacheDir(context.getCacheDir().getPath());
      config.setTrackedPoints(Config.ReportPoints.ON); // to draw them
      session = new Session(config);
    } catch (RuntimeException | Error e) {
      camera.close(); // has a thread of its own
      throw e;
    }
  }

  synchronized void resume() {
    session.resume();
    isResumed = true;
    startCamera();
  }

  synchronized void pause() {
    isResumed = false;
    camera.stop();
    session.pause();
  }

  /** Null, before the last one is released. */
  synchronized void setSurface(Surface newSurface) {
    camera.stop();
    surface = newSurface;
    startCamera();
  }

  private void startCamera() {
    if (isResumed && !isClosed && surface != null) {
      camera.start(surface);
    }
  }

  /** May take seconds, and waits for a frame that is being tracked; more than once is fine. */
  @Override
  public void close() {
    synchronized (this) {
      if (isClosed) {
        return;
      }
      isClosed = true;
      camera.close();
    }
    session.abandonGl(); // the context goes with the view
    session.close();
  }
}
