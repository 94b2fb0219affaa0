// The patch of a point in the reference: interpolated pixels and their central differences. Needs
// level_image, kHalfPatch and kPatchPixels; whoever includes it defines visitPixel.

const int kWide = PATCH_SIZE + 2;  // the patch and one pixel around it, for the central differences
const int kStrip = 4;  // columns walked at a time: rows of the whole patch would not fit into registers
const int kWideStrip = kStrip + 2;

// Takes a pixel of the patch: its grey level and its derivative.
void visitPixel(int row, int column, float i0, vec2 gradient);

// Mean of the patch around uv: neighbouring pixels share texels, whose weights add up to one. The loop over
// rows starts at a number that is not constant: unrolled, it would ask for all texels at once.
float patchMean(vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch;
  ivec2 last = first + PATCH_SIZE;
  vec2 fraction = fract(uv);
  float sum = 0.0;
  for (int y = first.y; y <= last.y; ++y) {
    float row = 0.0;
    for (int x = 0; x <= PATCH_SIZE; ++x) {
      float weight = x == 0 ? 1.0 - fraction.x : (x == PATCH_SIZE ? fraction.x : 1.0);
      row += weight * texelFetch(level_image, ivec2(first.x + x, y), 0).r;
    }
    sum += row * (y == first.y ? 1.0 - fraction.y : (y == last.y ? fraction.y : 1.0));
  }
  return sum / float(kPatchPixels);
}

// Columns x to x + kWideStrip - 1 of the widened patch, interpolated along x; `first` is the texel of column 0.
void sampleStrip(ivec2 first, int x, float fraction, out float row[kWideStrip]) {
  float left = texelFetch(level_image, first + ivec2(x, 0), 0).r;
  for (int c = 0; c < kWideStrip; ++c) {
    float right = texelFetch(level_image, first + ivec2(min(x + c + 1, kWide), 0), 0).r;
    row[c] = mix(left, right, fraction);
    left = right;
  }
}

// Visits columns x to x + kStrip - 1 of the patch, as far as there are so many.
void walkStrip(ivec2 first, vec2 fraction, int x) {
  // Interpolated rows y-1, y, y+1; `upper` and `lower` are texel rows.
  float before[kStrip], here[kWideStrip], after[kWideStrip], upper[kWideStrip], lower[kWideStrip];
  sampleStrip(first, x, fraction.x, upper);
  for (int c = 0; c < kWideStrip; ++c) here[c] = after[c] = 0.0;
  for (int y = 0; y < kWide; ++y) {
    sampleStrip(first + ivec2(0, y + 1), x, fraction.x, lower);
    for (int c = 0; c < kStrip; ++c) before[c] = here[c + 1];
    for (int c = 0; c < kWideStrip; ++c) {
      here[c] = after[c];
      after[c] = mix(upper[c], lower[c], fraction.y);
      upper[c] = lower[c];
    }
    if (y < 2) continue;
    for (int c = 0; c < kStrip && x + c < PATCH_SIZE; ++c) {
      vec2 gradient = 0.5 * vec2(here[c + 2] - here[c], after[c + 1] - before[c]);
      visitPixel(y - 2, x + c, here[c + 1], gradient);
    }
  }
}

// Visits every pixel of the patch around uv.
void walkPatch(vec2 uv) {
  ivec2 first = ivec2(floor(uv)) - kHalfPatch - 1;
  vec2 fraction = fract(uv);
  for (int x = 0; x < PATCH_SIZE; x += kStrip) walkStrip(first, fraction, x);
}
