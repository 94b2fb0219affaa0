package io.github.glideslam.android;

/** A rectangle of pixels, immutable: android.graphics.Rect without Android. */
public final class PixelRect {
  final int left;
  final int top;
  final int width;
  final int height;

  /** {@code left} and {@code top} are the place of the first pixel. */
  public PixelRect(int left, int top, int width, int height) {
    this.left = left;
    this.top = top;
    this.width = width;
    this.height = height;
  }
}
