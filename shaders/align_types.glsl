// The buffers that the alignment kernels share. Mirrors core/gpu/align_layout.h; the symbols are those
// of docs/algorithms/photometric-alignment.md.

const int kHalfPatch = PATCH_SIZE / 2;
const int kPatchPixels = PATCH_SIZE * PATCH_SIZE;
const int kRowPairs = (PATCH_SIZE + 1) / 2;

// Constants of one aligner.
layout(std140, binding = 0) uniform AlignConstants {
  vec4 focal_center;  // fx, fy, cx, cy of level 0, px
  vec4 distortion;    // k1 k2 p1 p2 or k1..k4
  vec4 lens;          // k3 of the radial-tangential model, CameraModel::maxRadius(), 0, 0
  vec4 robust;        // Huber factor, Huber floor, convergence, 0
  ivec4 limits;       // points that the buffers hold, min_points, gain_bias (0 or 1), constant H (0 or 1)
} constants;

// One point of the reference at one level.
struct PointRecord {
  vec4 p_ref;      // X, 1 when the patch is valid at this level
  vec4 jx_head;    // Jx 0..3
  vec4 jx_jy;      // Jx 4 5, Jy 0 1
  vec4 jy_tail;    // Jy 2..5
  vec4 moments;    // m0, E, Ex, Ey
  vec4 gradients;  // Gx, Gy, Gxx, Gxy
  vec4 rest;       // Gyy, 0, 0, 0
};

// A point in an alignment: what its patch sums up to at the current pose, and what the iterations carry.
struct PointSums {
  vec4 intensity;  // S1, S2, Sc, Sx
  vec4 rest;       // Sy, 1 when visible, weight, patch error
};

// The state of one alignment; lives on the GPU from the guess to the result.
struct AlignState {
  vec4 q_cam_ref;    // x y z w, unit
  vec4 t_cam_ref;    // xyz
  vec4 photometric;  // gain, bias, rms, contrast
  ivec4 counts;      // points, visible, inliers of level 0; 1 when the alignment has failed
  ivec4 flow;        // the level that has ended last, 1 once the weights hold values, 0, 0
  int iterations[8];  // evaluations of level 0..7
  float hessian[24];  // lower triangle of H, row by row, 21 values
};

// Index of the pair of values c (0: e, 1: gx, 2: gy) of the pixels 2 x pair and 2 x pair + 1 of a patch's row:
// neighbours in a group are neighbours in memory. The last pair of a row has one pixel.
int pairIndex(int level, int point, int row, int pair, int c) {
  return (((level * PATCH_SIZE + row) * kRowPairs + pair) * 3 + c) * constants.limits.x + point;
}

int recordIndex(int level, int point) { return level * constants.limits.x + point; }

// 2^-level, exactly.
float levelScale(int level) { return 1.0 / float(1 << level); }
