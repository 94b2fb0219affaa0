package io.github.glideslam.sample;

import android.content.Context;
import android.hardware.display.DisplayManager;
import android.os.Handler;
import android.os.Looper;
import android.view.Display;

/** Tells how the display is turned: also half turns, of which the activity is not told. */
final class DisplayRotation implements DisplayManager.DisplayListener {
  /** Told on the main thread. */
  interface Listener {
    void onRotation(int degrees);
  }

  // Surface.ROTATION_0 to ROTATION_270 count quarters.
  private static final int DEGREES_PER_QUARTER = 90;

  private final DisplayManager manager;
  private final Listener listener;

  DisplayRotation(Context context, Listener listener) {
    manager = (DisplayManager) context.getSystemService(Context.DISPLAY_SERVICE);
    this.listener = listener;
  }

  void start() {
    manager.registerDisplayListener(this, new Handler(Looper.getMainLooper()));
    onDisplayChanged(Display.DEFAULT_DISPLAY);
  }

  void stop() {
    manager.unregisterDisplayListener(this);
  }

  @Override
  public void onDisplayAdded(int display) {}

  @Override
  public void onDisplayRemoved(int display) {}

  @Override
  public void onDisplayChanged(int display) {
    if (display == Display.DEFAULT_DISPLAY) {
      listener.onRotation(DEGREES_PER_QUARTER * manager.getDisplay(display).getRotation());
    }
  }
}
