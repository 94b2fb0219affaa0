package io.github.glideslam.android;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import org.junit.Test;

public final class DisplayTransformTest {
  private static final float EXACT = 1e-4f;

  private static float[] imagePixel(DisplayTransform transform, float x, float y) {
    float[] pixel = new float[2];
    transform.viewToImage(x, y, pixel);
    return pixel;
  }

  @Test
  public void aPhoneHeldUprightTurnsTheSensorsImageByAQuarter() {
    assertEquals(90, DisplayTransform.imageRotation(90, 0));
    assertEquals(0, DisplayTransform.imageRotation(90, 90));
    assertEquals(180, DisplayTransform.imageRotation(90, 270));
    assertEquals(270, DisplayTransform.imageRotation(90, 180));
  }

  @Test
  public void unturnedViewsOfTheSameShapeAreScaledOnly() {
    DisplayTransform transform = new DisplayTransform(640, 480, 0, 1280, 960);
    assertArrayEquals(new float[] {-0.5f, -0.5f}, imagePixel(transform, 0, 0), EXACT);
    assertArrayEquals(new float[] {639.5f, 479.5f}, imagePixel(transform, 1280, 960), EXACT);
    float[] whole = {0, 1, 1, 1, 0, 0, 1, 0};
    assertArrayEquals(whole, transform.cornerTextureCoordinates(), EXACT);
  }

  /** Turned clockwise by 90 degrees the image's first column is the view's upper edge. */
  @Test
  public void quarterTurnsAreClockwise() {
    DisplayTransform transform = new DisplayTransform(640, 480, 90, 480, 640);
    assertArrayEquals(new float[] {-0.5f, 479.5f}, imagePixel(transform, 0, 0), EXACT);
    assertArrayEquals(new float[] {-0.5f, -0.5f}, imagePixel(transform, 480, 0), EXACT);
    assertArrayEquals(new float[] {639.5f, 479.5f}, imagePixel(transform, 0, 640), EXACT);
  }

  @Test
  public void threeQuartersAndHalfTurnsGoTheOtherWays() {
    DisplayTransform threeQuarters = new DisplayTransform(640, 480, 270, 480, 640);
    assertArrayEquals(new float[] {639.5f, -0.5f}, imagePixel(threeQuarters, 0, 0), EXACT);
    DisplayTransform half = new DisplayTransform(640, 480, 180, 640, 480);
    assertArrayEquals(new float[] {639.5f, 479.5f}, imagePixel(half, 0, 0), EXACT);
  }

  @Test
  public void fromTheImageToTheViewIsTheWayBackHoweverItIsTurned() {
    for (int rotation = 0; rotation < 360; rotation += 90) {
      DisplayTransform transform = new DisplayTransform(640, 480, rotation, 480, 960);
      float[] pixel = imagePixel(transform, 37, 801);
      float[] point = new float[2];
      transform.imageToView(pixel[0], pixel[1], point);
      assertArrayEquals(new float[] {37, 801}, point, EXACT);
    }
  }

  /** A tall view shows the middle of a wide image, at the view's height. */
  @Test
  public void otherShapesShowTheMiddle() {
    DisplayTransform transform = new DisplayTransform(640, 480, 0, 480, 960);
    assertArrayEquals(new float[] {319.5f, 239.5f}, imagePixel(transform, 240, 480), EXACT);
    assertArrayEquals(new float[] {199.5f, -0.5f}, imagePixel(transform, 0, 0), EXACT);
    float left = 200 / 640f;
    float right = 440 / 640f;
    float[] middle = {left, 1, right, 1, left, 0, right, 0};
    assertArrayEquals(middle, transform.cornerTextureCoordinates(), EXACT);
  }
}
