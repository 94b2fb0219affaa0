package io.github.glideslam.android;

import io.github.glideslam.android.Camera2Source.Listener;
import io.github.glideslam.android.Camera2Source.State;
import java.util.ArrayDeque;
import java.util.Queue;

/**
 * Tells a listener states in the order in which they were added, one at a time, from any threads. No
 * lock is held while the listener runs: it may start and stop the camera.
 */
final class StateTeller {
  private static final class News {
    final State state;
    final String reason;

    News(State state, String reason) {
      this.state = state;
      this.reason = reason;
    }
  }

  private final Listener listener;
  private final Queue<News> waiting = new ArrayDeque<>();
  private boolean isTelling;

  /** {@code listener} may be null. */
  StateTeller(Listener listener) {
    this.listener = listener;
  }

  synchronized void add(State state, String reason) {
    if (listener != null) {
      waiting.add(new News(state, reason));
    }
  }

  /** Tells what waits, unless this is going on already: then it is told there. */
  void tell() {
    News news = begin();
    try {
      while (news != null) {
        listener.onStateChanged(news.state, news.reason);
        news = next();
      }
    } finally {
      if (news != null) { // the listener threw: what is left comes with the next state
        end();
      }
    }
  }

  private synchronized News begin() {
    if (isTelling) {
      return null;
    }
    isTelling = true;
    return next();
  }

  private synchronized News next() {
    News news = waiting.poll();
    isTelling = news != null;
    return news;
  }

  private synchronized void end() {
    isTelling = false;
  }
}
