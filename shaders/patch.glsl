// Sampling of a patch without filtering hardware: r32f textures need not be filterable in ES 3.1, and all
// pixels of a patch share one fractional position. A macro, because an array of PATCH_SIZE and one of
// PATCH_SIZE + 2 are different types.

// row[0..count-1] = samples interpolated along x from texel `first` on; `fraction` in 0..1.
#define SAMPLE_ROW(image, first, fraction, row, count) \
  {                                                    \
    ivec2 texel_ = (first);                            \
    float left_ = texelFetch(image, texel_, 0).r;      \
    for (int x_ = 0; x_ < (count); ++x_) {             \
      texel_.x += 1;                                   \
      float right_ = texelFetch(image, texel_, 0).r;   \
      row[x_] = mix(left_, right_, fraction);          \
      left_ = right_;                                  \
    }                                                  \
  }

// Whether low <= uv < size - high in x and in y. False for NaN.
bool isInside(vec2 uv, float low, vec2 size, float high) {
  return all(greaterThanEqual(uv, vec2(low))) && all(lessThan(uv, size - high));
}
