// The patch of a point in the reference: interpolated pixels and their central differences. Needs
// level_image, kHalfPatch, kPatchPixels and patch.glsl; whoever includes it defines visitPixel.

const int kWide = PATCH_SIZE + 2;  // the patch and one pixel around it, for the central differences

// Takes a pixel of the patch: its grey level and its derivative.
void visitPixel(int row, int column, float i0, vec2 gradient);

// Mean of the patch around uv.
float patchMean(vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch;
  vec2 fraction = fract(uv);
  float row[PATCH_SIZE];
  float sum = 0.0;
  for (int y = 0; y <= PATCH_SIZE; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y), fraction.x, row, PATCH_SIZE)
    float weight = y == 0 ? 1.0 - fraction.y : (y == PATCH_SIZE ? fraction.y : 1.0);
    float row_sum = 0.0;
    for (int x = 0; x < PATCH_SIZE; ++x) row_sum += row[x];
    sum += weight * row_sum;
  }
  return sum / float(kPatchPixels);
}

// Visits every pixel of the patch around uv.
void walkPatch(vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch - 1;
  vec2 fraction = fract(uv);
  // Interpolated rows y-1, y, y+1 of the widened patch; `upper` and `lower` are texel rows.
  float before[kWide], here[kWide], after[kWide], upper[kWide], lower[kWide];
  SAMPLE_ROW(level_image, first, fraction.x, upper, kWide)
  for (int x = 0; x < kWide; ++x) here[x] = after[x] = 0.0;
  for (int y = 0; y < kWide; ++y) {
    SAMPLE_ROW(level_image, first + ivec2(0, y + 1), fraction.x, lower, kWide)
    for (int x = 0; x < kWide; ++x) {
      before[x] = here[x];
      here[x] = after[x];
      after[x] = mix(upper[x], lower[x], fraction.y);
      upper[x] = lower[x];
    }
    if (y < 2) continue;
    for (int x = 0; x < PATCH_SIZE; ++x) {
      vec2 gradient = 0.5 * vec2(here[x + 2] - here[x], after[x + 1] - before[x + 1]);
      visitPixel(y - 2, x, here[x + 1], gradient);
    }
  }
}
