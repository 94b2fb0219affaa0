package io.github.glideslam.android;

import android.util.Range;
import android.util.Size;

/** Which of the sizes and frame rates that a camera offers suit tracking. */
final class StreamChoice {
  // Aspects that differ less are the same.
  private static final double SAME_ASPECT = 0.01;

  /** The offered size nearest to the wanted one; another aspect only when none has the same. */
  static Size size(Size[] offered, Size wanted) {
    Size best = null;
    double bestDistance = Double.POSITIVE_INFINITY;
    for (Size size : offered) {
      double distance = distance(size, wanted);
      if (distance < bestDistance) {
        best = size;
        bestDistance = distance;
      }
    }
    return best;
  }

  /** Octaves of area, and far more than there are for another aspect. */
  private static double distance(Size size, Size wanted) {
    double aspects = Math.log(aspect(size) / aspect(wanted));
    double areas = Math.log(area(size) / area(wanted));
    return Math.abs(areas) + (Math.abs(aspects) > SAME_ASPECT ? Double.MAX_EXPONENT : 0);
  }

  private static double aspect(Size size) {
    return (double) size.getWidth() / size.getHeight();
  }

  private static double area(Size size) {
    return (double) size.getWidth() * size.getHeight();
  }

  /**
   * The offered range whose end is nearest to {@code wanted} frames a second, and of those the one
   * that begins last: a range of one rate keeps dark rooms from stretching the exposure.
   */
  static Range<Integer> frameRate(Range<Integer>[] offered, int wanted) {
    Range<Integer> best = null;
    for (Range<Integer> range : offered) {
      if (best == null || isBetter(range, best, wanted)) {
        best = range;
      }
    }
    return best;
  }

  private static boolean isBetter(Range<Integer> range, Range<Integer> best, int wanted) {
    int distance = Math.abs(range.getUpper() - wanted);
    int bestDistance = Math.abs(best.getUpper() - wanted);
    return distance != bestDistance
        ? distance < bestDistance
        : range.getLower() > best.getLower();
  }

  private StreamChoice() {}
}
