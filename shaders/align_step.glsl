// Solve and update, by one invocation: reads total[0..26] (align_cholesky.glsl) and moves state's pose. Needs
// rigid.glsl.

const float kDamping = 1e-6;
const float kMinPivot = 1e-9;
const float kHuge = 1e30;  // a step beyond is not finite for our purposes

#include "align_cholesky.glsl"

// Length of the step, as a twist; kHuge, and the alignment has failed, when there is none.
float takeStep() {
  vec3 v, w;
  if (!solveDamped(v, w)) {
    state.counts.w = 1;
    return kHuge;
  }
  vec4 q_step;
  vec3 t_step;
  expTwist(-v, -w, q_step, t_step);
  state.t_cam_ref.xyz += rotate(state.q_cam_ref, t_step);
  state.q_cam_ref = normalize(multiplyQuaternions(state.q_cam_ref, q_step));
  return sqrt(dot(v, v) + dot(w, w));
}
