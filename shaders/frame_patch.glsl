// The patch of a point in the frame, interpolated row by row without filtering hardware: r32f textures need
// not be filterable in ES 3.1, and all pixels of a patch share one fractional position. One gather brings
// four texels, and of the patch two rows are held at a time, in pairs of pixels and the last one: loops that
// run once over an array are unrolled by the compilers that we know. Needs level_image; whoever includes it
// defines visitFramePixel.

const int kPairs = PATCH_SIZE / 2;  // of pixels in a row; one more pixel follows them

// Takes the next pixel of the patch, row by row.
void visitFramePixel(float i);

// Two rows of the patch's texels, interpolated along x: `upper` and `lower`, and in `ends` their last pixels.
// `at` is the corner in the middle of the first four texels, where rounding cannot choose others. A macro,
// because functions would copy the arrays.
#define GATHER_TWO_ROWS(at, step, fraction, upper, lower, ends)              \
  {                                                                          \
    vec2 at_ = (at);                                                         \
    vec4 quad_ = textureGather(level_image, at_);                            \
    for (int x_ = 0; x_ < kPairs; ++x_) {                                    \
      at_.x += (step);                                                       \
      vec4 next_ = textureGather(level_image, at_);                          \
      upper[x_] = mix(quad_.wz, vec2(quad_.z, next_.w), fraction);           \
      lower[x_] = mix(quad_.xy, vec2(quad_.y, next_.x), fraction);           \
      quad_ = next_;                                                         \
    }                                                                        \
    ends = mix(quad_.wx, quad_.zy, fraction);                                \
  }

// Visits the pixels of a row between two texel rows.
#define VISIT_ROW(above, above_end, below, below_end, fraction) \
  {                                                             \
    for (int x_ = 0; x_ < kPairs; ++x_) {                       \
      vec2 pair_ = mix(above[x_], below[x_], fraction);         \
      visitFramePixel(pair_.x);                                 \
      visitFramePixel(pair_.y);                                 \
    }                                                           \
    visitFramePixel(mix(above_end, below_end, fraction));       \
  }

// Visits every pixel of the patch around uv.
void walkFramePatch(vec2 uv) {
  vec2 corner = floor(uv);
  vec2 fraction = uv - corner;
  vec2 texel = 1.0 / vec2(textureSize(level_image, 0));
  vec2 at = (corner - float(kHalfPatch - 1)) * texel;
  vec2 upper[kPairs], lower[kPairs], last[kPairs];
  vec2 ends;
  GATHER_TWO_ROWS(at, 2.0 * texel.x, fraction.x, upper, last, ends)
  VISIT_ROW(upper, ends.x, last, ends.y, fraction.y)
  for (int y = 0; y < kPairs; ++y) {
    float last_end = ends.y;
    at.y += 2.0 * texel.y;
    GATHER_TWO_ROWS(at, 2.0 * texel.x, fraction.x, upper, lower, ends)
    VISIT_ROW(last, last_end, upper, ends.x, fraction.y)
    VISIT_ROW(upper, ends.x, lower, ends.y, fraction.y)
    for (int x = 0; x < kPairs; ++x) last[x] = lower[x];
  }
}
