// The patch of a point in the frame, interpolated without filtering hardware: r32f textures need not be
// filterable in ES 3.1, and all pixels of a patch share one fractional position. One gather brings two more
// pixels, and two numbers of the last one are kept: holding a row would take so many registers that fewer
// threads run at a time on a GPU. Needs level_image; whoever includes it defines visitFramePair and visitFrameEnd.

// Takes the next two pixels of the patch, row by row.
void visitFramePair(vec2 i);
// Takes the last pixel of a row.
void visitFrameEnd(float i);

// Texel columns x and x + 1, interpolated along y. `at` is the corner in the middle of the four texels, where
// rounding cannot choose others.
vec2 gatherColumns(vec2 at, float fraction) {
  vec4 quad = textureGather(level_image, at);
  return mix(quad.wz, quad.xy, fraction);
}

// Visits every pixel of the patch around uv. The loops start at numbers that are not constant: unrolled, they
// would ask for many texels at once.
void walkFramePatch(vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch;
  ivec2 end = first + PATCH_SIZE;
  vec2 fraction = fract(uv);
  vec2 texel = 1.0 / vec2(textureSize(level_image, 0));
  for (int y = first.y; y < end.y; ++y) {
    vec2 at = vec2(first.x + 1, y + 1) * texel;
    vec2 columns = gatherColumns(at, fraction.y);
    for (int x = first.x + 2; x < end.x; x += 2) {
      at.x += 2.0 * texel.x;
      vec2 next = gatherColumns(at, fraction.y);
      visitFramePair(mix(columns, vec2(columns.y, next.x), fraction.x));
      columns = next;
    }
    visitFrameEnd(mix(columns.x, columns.y, fraction.x));
  }
}
