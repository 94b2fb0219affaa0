// Steps 1 to 7 of an iteration, by one workgroup; invocation i owns the points i, i + GROUP_SIZE, ... Needs
// records, sums, state, level, point_count and all_points. Sums are taken in a fixed order, so that a result
// repeats: each invocation over its own points, then invocation k over the partial sums of quantity k. That is
// two barriers a reduction; a tree would be six.

const int kEquationSums = 31;  // H 21, b 6, w rho, w, inliers, contrast; at most GROUP_SIZE
const int kRowStride = GROUP_SIZE + 1;  // odd: the readers of a column touch different banks
const float kMinGain = 0.2;
const float kMaxGain = 5.0;

shared float partial[kEquationSums * kRowStride];
shared float total[kEquationSums];

#include "align_step.glsl"

// partial[k][all invocations] -> total[k] for k < count.
void reduce(int count) {
  memoryBarrierShared();
  barrier();
  int k = int(gl_LocalInvocationID.x);
  if (k < count) {
    float sum = 0.0;
    for (int i = 0; i < GROUP_SIZE; ++i) sum += partial[k * kRowStride + i];
    total[k] = sum;
  }
  memoryBarrierShared();
  barrier();
}

void putPartial(int k, float value) { partial[k * kRowStride + int(gl_LocalInvocationID.x)] = value; }

void putPartials(int k, vec3 values) {
  putPartial(k, values.x);
  putPartial(k + 1, values.y);
  putPartial(k + 2, values.z);
}

bool has_weights;  // whether an iteration of this alignment has left its weights

// The weight of the previous iteration; all are one when a new alignment starts.
float oldWeight(int point) { return has_weights ? sums[point].rest.z : 1.0; }

struct Exposure {
  float gain;
  float bias;
  float weight;  // sum of the old weights of the visible points
  int points;    // valid ones
  int visible;
};

// Step 1.
Exposure estimateExposure() {
  float part[7] = float[7](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  float n = float(kPatchPixels);
  for (int i = int(gl_LocalInvocationID.x); i < point_count; i += GROUP_SIZE) {
    int at = recordIndex(level, i);
    part[0] += records[at].p_ref.w;
    if (sums[i].rest.y < 0.5) continue;
    float w = oldWeight(i);
    vec4 intensity = sums[i].intensity;
    vec4 moments = records[at].moments;
    part[1] += 1.0;
    part[2] += w * (intensity.y - intensity.x * intensity.x / n);
    part[3] += w * moments.y;
    part[4] += w * (intensity.x / n + moments.x);
    part[5] += w * moments.x;
    part[6] += w;
  }
  for (int k = 0; k < 7; ++k) putPartial(k, part[k]);
  reduce(7);
  Exposure result = Exposure(1.0, 0.0, total[6], int(total[0]), int(total[1]));
  if (constants.limits.z != 0 && total[3] > 0.0) {
    result.gain = clamp(sqrt(max(total[2], 0.0) / total[3]), kMinGain, kMaxGain);
    result.bias = (total[4] - result.gain * total[5]) / total[6];
  }
  return result;
}

// Step 2: sum r^2, sum gx r, sum gy r of a visible point.
vec3 residualSums(int point, Exposure exposure) {
  int at = recordIndex(level, point);
  vec4 moments = records[at].moments;
  vec4 gradients = records[at].gradients;
  vec4 s = sums[point].intensity;
  float c = moments.x - exposure.bias - exposure.gain * moments.x;
  float a = exposure.gain;
  float squares = (s.y + 2.0 * c * s.x + float(kPatchPixels) * c * c) / (a * a) - 2.0 * s.z / a + moments.y;
  vec2 along = (vec2(s.w, sums[point].rest.x) + c * gradients.xy) / a - moments.zw;
  return vec3(squares, along);
}

// Steps 2 and 3: the patch errors, and the Huber threshold.
float huberThreshold(Exposure exposure) {
  float weighted = 0.0;
  for (int i = int(gl_LocalInvocationID.x); i < point_count; i += GROUP_SIZE) {
    float w = oldWeight(i);
    float rho = 0.0;
    if (sums[i].rest.y > 0.5) {
      rho = sqrt(max(residualSums(i, exposure).x, 0.0) / float(kPatchPixels));
      weighted += w * rho;
    }
    sums[i].rest.zw = vec2(w, rho);
  }
  // Points that are not valid before a finer level start there with a weight of one.
  int later = int(gl_LocalInvocationID.x) + point_count;
  for (int i = later; !has_weights && i < all_points; i += GROUP_SIZE) sums[i].rest.z = 1.0;
  putPartial(0, weighted);
  reduce(1);
  return max(constants.robust.x * total[0] / exposure.weight, constants.robust.y);
}

// J of a point: rows of u and v, by translation and rotation.
struct Rows {
  vec3 u_v, u_w, v_v, v_w;
};

Rows rowsOf(int point) {
  int at = recordIndex(level, point);
  vec4 head = records[at].jx_head;
  vec4 middle = records[at].jx_jy;
  vec4 tail = records[at].jy_tail;
  return Rows(head.xyz, vec3(head.w, middle.xy), vec3(middle.zw, tail.x), tail.yzw);
}

// Step 4 and the right side: new weights, b and the numbers that are reported, as partial sums 21 to 30.
void sumRightSide(Exposure exposure, float threshold) {
  vec3 b_v = vec3(0.0);
  vec3 b_w = vec3(0.0);
  vec4 reported = vec4(0.0);  // w rho, w, inliers, contrast
  for (int i = int(gl_LocalInvocationID.x); i < point_count; i += GROUP_SIZE) {
    int at = recordIndex(level, i);
    if (sums[i].rest.y < 0.5 || records[at].p_ref.w < 0.5) continue;
    float rho = sums[i].rest.w;
    bool inlier = rho <= threshold;
    float weight = inlier || constants.limits.w != 0 ? 1.0 : threshold / rho;
    sums[i].rest.z = weight;
    reported += vec4(weight * rho, weight, inlier ? 1.0 : 0.0, sqrt(records[at].moments.y / float(kPatchPixels)));
    vec2 along = weight * residualSums(i, exposure).yz;
    Rows J = rowsOf(i);
    b_v += J.u_v * along.x + J.v_v * along.y;
    b_w += J.u_w * along.x + J.v_w * along.y;
  }
  putPartials(21, b_v);
  putPartials(24, b_w);
  putPartials(27, reported.xyz);
  putPartial(30, reported.w);
}

// Step 5: H, as partial sums 0 to 20. Apart from the right side, because both would not fit into registers, and
// written out, because an array that is indexed in loops would be in memory.
void sumHessian() {
  vec3 vv_diagonal = vec3(0.0);  // of translation
  vec3 vv_below = vec3(0.0);     // 10 20 21
  vec3 wv0 = vec3(0.0);
  vec3 wv1 = vec3(0.0);
  vec3 wv2 = vec3(0.0);
  vec3 ww_diagonal = vec3(0.0);  // of rotation
  vec3 ww_below = vec3(0.0);
  for (int i = int(gl_LocalInvocationID.x); i < point_count; i += GROUP_SIZE) {
    int at = recordIndex(level, i);
    if (records[at].p_ref.w < 0.5) continue;
    float weight = constants.limits.w != 0 ? 1.0 : sums[i].rest.z * step(0.5, sums[i].rest.y);
    vec2 xx_xy = weight * records[at].gradients.zw;
    float yy = weight * records[at].rest.x;
    Rows J = rowsOf(i);
    vec3 u = J.u_v * xx_xy.x + J.v_v * xx_xy.y;
    vec3 v = J.u_v * xx_xy.y + J.v_v * yy;
    vv_diagonal += u * J.u_v + v * J.v_v;
    vv_below += u.yzz * J.u_v.xxy + v.yzz * J.v_v.xxy;
    u = J.u_w * xx_xy.x + J.v_w * xx_xy.y;
    v = J.u_w * xx_xy.y + J.v_w * yy;
    wv0 += u.x * J.u_v + v.x * J.v_v;
    wv1 += u.y * J.u_v + v.y * J.v_v;
    wv2 += u.z * J.u_v + v.z * J.v_v;
    ww_diagonal += u * J.u_w + v * J.v_w;
    ww_below += u.yzz * J.u_w.xxy + v.yzz * J.v_w.xxy;
  }
  putPartials(0, vec3(vv_diagonal.x, vv_below.x, vv_diagonal.y));
  putPartials(3, vec3(vv_below.yz, vv_diagonal.z));
  putPartials(6, wv0);
  putPartial(9, ww_diagonal.x);
  putPartials(10, wv1);
  putPartial(13, ww_below.x);
  putPartial(14, ww_diagonal.y);
  putPartials(15, wv2);
  putPartials(18, vec3(ww_below.yz, ww_diagonal.z));
}

// Steps 4 and 5: total = H, b and the numbers that are reported.
void formEquations(Exposure exposure, float threshold) {
  sumRightSide(exposure, threshold);
  sumHessian();
  reduce(kEquationSums);
}

void report(Exposure exposure) {
  state.photometric = vec4(exposure.gain, exposure.bias, total[27] / total[28], total[30] / float(exposure.visible));
  state.counts.xyz = ivec3(exposure.points, exposure.visible, int(total[29]));
  state.flow.y = 1;
  state.iterations[level] += 1;
  for (int k = 0; k < 21; ++k) state.hessian[k] = total[k];
}

// One iteration from the sums at the current pose to the next pose; false, in all invocations, when too few
// points are visible. Only the first invocation has the new state.
bool iterate() {
  bool first = gl_LocalInvocationID.x == 0u;
  Exposure exposure = estimateExposure();
  if (exposure.visible < constants.limits.y) {  // covers too few valid points: visible ones are valid
    if (first) state.flow.x = level;
    if (first && level == 0) state.counts = ivec4(exposure.points, exposure.visible, 0, 1);
    return false;
  }
  float threshold = huberThreshold(exposure);
  formEquations(exposure, threshold);
  if (first) {
    report(exposure);
    if (takeStep() < constants.robust.z) state.flow.x = level;  // steps 6 and 7
  }
  return true;
}
