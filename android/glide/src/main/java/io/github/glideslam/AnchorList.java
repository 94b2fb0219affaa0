package io.github.glideslam;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;

/** The anchors of a session that are not detached. Any thread. */
final class AnchorList {
  private final List<Anchor> anchors = new ArrayList<>();
  private final List<Anchor> updated = new ArrayList<>();
  private final Collection<Anchor> updatedView = Collections.unmodifiableList(updated);
  private boolean isStale;

  synchronized Anchor add(Anchor anchor) {
    anchors.add(anchor);
    return anchor;
  }

  synchronized void remove(Anchor anchor) {
    anchors.remove(anchor);
  }

  synchronized Collection<Anchor> copy() {
    return new ArrayList<>(anchors);
  }

  /** After an update: {@link #updated} has to look again. */
  synchronized void setStale() {
    isStale = true;
  }

  /** Those that have changed since the last update for which this was called; the same each time. */
  synchronized Collection<Anchor> updated() {
    if (isStale) {
      isStale = false;
      updated.clear();
      for (int i = 0; i < anchors.size(); ++i) {
        if (anchors.get(i).takeUpdate()) {
          updated.add(anchors.get(i));
        }
      }
    }
    return updatedView;
  }
}
