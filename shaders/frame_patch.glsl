// The patch of a point in the frame, interpolated without filtering hardware: r32f textures need not be
// filterable in ES 3.1, and all pixels of a patch share one fractional position. One gather brings four texels;
// from one pair of texel rows to the next only the lower row is kept, so that a GPU needs few registers. Needs
// level_image; whoever includes it defines visitFramePair and visitFrameEnd.

const int kFullPairs = PATCH_SIZE / 2;  // of pixels in a row; one more pixel follows them

// Takes the next two pixels of a row of the patch. Two rows are walked at a time: `row` is 0 or 1.
void visitFramePair(int row, vec2 i);
// Takes the last pixel of a row.
void visitFrameEnd(int row, float i);

// Visits every pixel of the patch around uv: the first row as row 1, then two rows at a time.
void walkFramePatch(vec2 uv) {
  vec2 corner = floor(uv);
  vec2 fraction = uv - corner;
  vec2 texel = 1.0 / vec2(textureSize(level_image, 0));
  // The corner in the middle of the first four texels, where rounding cannot choose others.
  vec2 left = (corner - float(kHalfPatch - 1)) * texel;
  // The texel row above, interpolated along x. Loops over an array that run once over all of it are unrolled by
  // every compiler that we know.
  vec2 above[kFullPairs];
  float above_end;

  vec2 at = left;
  vec4 quad = textureGather(level_image, at);
  for (int x = 0; x < kFullPairs; ++x) {
    at.x += 2.0 * texel.x;
    vec4 next = textureGather(level_image, at);
    vec2 upper = mix(quad.wz, vec2(quad.z, next.w), fraction.x);
    above[x] = mix(quad.xy, vec2(quad.y, next.x), fraction.x);
    visitFramePair(1, mix(upper, above[x], fraction.y));
    quad = next;
  }
  vec2 ends = mix(quad.wx, quad.zy, fraction.x);
  visitFrameEnd(1, mix(ends.x, ends.y, fraction.y));
  above_end = ends.y;

  for (int y = 0; y < kFullPairs; ++y) {
    left.y += 2.0 * texel.y;
    at = left;
    quad = textureGather(level_image, at);
    for (int x = 0; x < kFullPairs; ++x) {
      at.x += 2.0 * texel.x;
      vec4 next = textureGather(level_image, at);
      vec2 upper = mix(quad.wz, vec2(quad.z, next.w), fraction.x);
      vec2 lower = mix(quad.xy, vec2(quad.y, next.x), fraction.x);
      visitFramePair(0, mix(above[x], upper, fraction.y));
      visitFramePair(1, mix(upper, lower, fraction.y));
      above[x] = lower;
      quad = next;
    }
    ends = mix(quad.wx, quad.zy, fraction.x);
    visitFrameEnd(0, mix(above_end, ends.x, fraction.y));
    visitFrameEnd(1, mix(ends.x, ends.y, fraction.y));
    above_end = ends.y;
  }
}
