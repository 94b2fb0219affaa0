package io.github.glideslam.sample;

import android.opengl.Matrix;
import io.github.glideslam.Anchor;
import io.github.glideslam.Frame;
import io.github.glideslam.HitResult;
import io.github.glideslam.TrackingState;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/** Cubes on anchors. GL thread. */
final class PlacedCubes {
  // Of the distance at which a cube was placed: the scene's units are arbitrary.
  private static final float SIZE = 0.15f;

  private static final class Placed {
    final Anchor anchor;
    final float size;

    Placed(Anchor anchor, float size) {
      this.anchor = anchor;
      this.size = size;
    }
  }

  private final List<Placed> cubes = new ArrayList<>();
  private final float[] worldFromCube = new float[16];
  private final float[] clipFromCube = new float[16];

  /** On what lies under a pixel of the camera's image; false when there is nothing. */
  boolean place(Frame frame, float[] pixel) {
    List<HitResult> hits = frame.hitTest(pixel[0], pixel[1]);
    if (hits.isEmpty()) {
      return false;
    }
    HitResult nearest = hits.get(0);
    cubes.add(new Placed(nearest.createAnchor(), SIZE * nearest.getDistance()));
    return true;
  }

  void draw(Cube cube, float[] clipFromWorld) {
    for (Iterator<Placed> it = cubes.iterator(); it.hasNext(); ) {
      Placed placed = it.next();
      if (placed.anchor.getTrackingState() == TrackingState.STOPPED) {
        placed.anchor.detach(); // its map is gone
        it.remove();
        continue;
      }
      placed.anchor.getPose().toMatrix(worldFromCube, 0);
      Matrix.scaleM(worldFromCube, 0, placed.size, placed.size, placed.size);
      Matrix.multiplyMM(clipFromCube, 0, clipFromWorld, 0, worldFromCube, 0);
      cube.draw(clipFromCube);
    }
  }
}
