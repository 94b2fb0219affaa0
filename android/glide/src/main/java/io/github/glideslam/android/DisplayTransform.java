package io.github.glideslam.android;

/**
 * Between the pixels of the camera's image and those of the view that it fills: turned upright,
 * scaled, its middle cut out, as {@link io.github.glideslam.Session#setDisplayGeometry} has it for the
 * matrices. Immutable; no Android types.
 */
public final class DisplayTransform {
  private static final int FULL_TURN = 360;
  private static final int QUARTER_TURN = 90;
  // From the corner of a pixel to its centre.
  private static final float PIXEL_CENTRE = 0.5f;

  private final int imageWidth;
  private final int imageHeight;
  private final int viewWidth;
  private final int viewHeight;
  private final int cos;
  private final int sin;
  private final float viewPerImage;

  /** {@code rotationDegrees} is that of setDisplayGeometry: 0, 90, 180 or 270. */
  public DisplayTransform(
      int imageWidth, int imageHeight, int rotationDegrees, int viewWidth, int viewHeight) {
    this.imageWidth = imageWidth;
    this.imageHeight = imageHeight;
    this.viewWidth = viewWidth;
    this.viewHeight = viewHeight;
    int quarters = rotationDegrees / QUARTER_TURN;
    cos = quarters == 0 ? 1 : quarters == 2 ? -1 : 0;
    sin = quarters == 1 ? 1 : quarters == 3 ? -1 : 0;
    boolean isTurned = sin != 0;
    float uprightWidth = isTurned ? imageHeight : imageWidth;
    float uprightHeight = isTurned ? imageWidth : imageHeight;
    viewPerImage = Math.max(viewWidth / uprightWidth, viewHeight / uprightHeight);
  }

  /**
   * By how much the image of a camera on the device's back is turned clockwise to be upright: from
   * SENSOR_ORIENTATION and the display's rotation (Surface.ROTATION_90 is 90), degrees.
   */
  public static int imageRotation(int sensorOrientation, int displayRotationDegrees) {
    return (sensorOrientation - displayRotationDegrees + FULL_TURN) % FULL_TURN;
  }

  /** The pixel of the image (for Frame.hitTest) under a point of the view (of a MotionEvent). */
  public void viewToImage(float x, float y, float[] imagePixel) {
    float dx = (x - viewWidth / 2f) / viewPerImage;
    float dy = (y - viewHeight / 2f) / viewPerImage;
    imagePixel[0] = cos * dx + sin * dy + imageWidth / 2f - PIXEL_CENTRE;
    imagePixel[1] = -sin * dx + cos * dy + imageHeight / 2f - PIXEL_CENTRE;
  }

  /** The point of the view where a pixel of the image (of TrackedPoints) is seen; outside of it, too. */
  public void imageToView(float u, float v, float[] viewPoint) {
    float dx = (u + PIXEL_CENTRE - imageWidth / 2f) * viewPerImage;
    float dy = (v + PIXEL_CENTRE - imageHeight / 2f) * viewPerImage;
    viewPoint[0] = cos * dx - sin * dy + viewWidth / 2f;
    viewPoint[1] = sin * dx + cos * dy + viewHeight / 2f;
  }

  /**
   * Texture coordinates of the camera's image, its first row at t = 0, at the view's corners: lower
   * left, lower right, upper left, upper right (a GL_TRIANGLE_STRIP that fills the view).
   */
  public float[] cornerTextureCoordinates() {
    float[] coordinates = new float[8];
    float[] pixel = new float[2];
    for (int i = 0; i < 4; ++i) {
      viewToImage(i % 2 * viewWidth, (1 - i / 2) * viewHeight, pixel);
      coordinates[2 * i] = (pixel[0] + PIXEL_CENTRE) / imageWidth;
      coordinates[2 * i + 1] = (pixel[1] + PIXEL_CENTRE) / imageHeight;
    }
    return coordinates;
  }
}
