// The buffers of the paper's plan (GpuPlan::paper). Mirrors core/gpu/paper_plan.cpp. Needs align_types.glsl.

const int kSlice = 7;          // floats of a pixel in the cache: I0 and the six entries of J
const int kHessianFloats = 24; // lower triangle of H_i row by row, 21 values, then the count of valid points

// What the residual kernel says of a point.
struct PaperTerm {
  vec4 b_head;  // b 0..3
  vec4 rest;    // b 4 5, patch error, contrast; the error is negative when the point is not visible
};

// What a level's terms add up to.
struct PaperTotal {
  float b[6];
  float visible;
  float inliers;
  float error;     // sum of the patch errors
  float contrast;  // sum of the contrasts
  float pad[2];
};

// First float of the slice of a point: slices of points follow each other.
int sliceIndex(int level, int point) { return (level * constants.limits.x + point) * kPatchPixels * kSlice; }
