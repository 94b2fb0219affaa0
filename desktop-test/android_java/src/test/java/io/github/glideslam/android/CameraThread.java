package io.github.glideslam.android;

import android.os.HandlerThread;
import java.util.HashSet;
import java.util.Set;
import org.robolectric.shadow.api.Shadow;
import org.robolectric.shadows.ShadowLooper;

/** The thread of each Camera2Source. */
public final class CameraThread {
  /** Those that live. */
  public static Set<Thread> alive() {
    Set<Thread> threads = new HashSet<>();
    for (Thread thread : Thread.getAllStackTraces().keySet()) {
      if (thread.getName().equals("glide-camera")) {
        threads.add(thread);
      }
    }
    return threads;
  }

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
