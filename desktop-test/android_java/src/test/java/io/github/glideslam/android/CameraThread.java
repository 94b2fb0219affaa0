package io.github.glideslam.android;

import android.os.HandlerThread;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowLooper;

/** The thread of each Camera2Source. */
public final class CameraThread {
  /** Waits until it has nothing left to do. */
  public static void settle() {
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread instanceof HandlerThread && thread.isAlive()) {
        ShadowLooper looper = Shadow.extract(((HandlerThread) thread).getLooper());
        looper.idle();
      }
    }
    ShadowLooper.idleMainLooper();
  }

  private CameraThread() {}
}
