#include "replay/evaluation/evaluate.h"

namespace glide::replay {

Trajectory truthInFrame(const GroundTruth& truth,
                        RigFrame frame,
                        const std::optional<SE3d>& T_body_cam) {
  if (truth.rig == frame || !T_body_cam) return truth.poses;
  return inFrame(truth.poses, frame == RigFrame::camera ? *T_body_cam : T_body_cam->inverse());
}

Estimates toBody(const Estimates& camera, const SE3d& T_body_cam, double scale) {
  SE3d T_cam_body = T_body_cam.inverse();
  T_cam_body.t /= scale;
  return {inFrame(camera.recomposed, T_cam_body),
          inFrame(camera.live, T_cam_body),
          inFrame(camera.keyframes, T_cam_body)};
}

Accuracy evaluate(const Trajectory& truth, const Estimates& estimates) {
  Accuracy accuracy;
  accuracy.matched = static_cast<int>(associate(truth, estimates.recomposed).size());
  accuracy.final_error = absoluteError(truth, estimates.recomposed);
  accuracy.live_error = absoluteError(truth, estimates.live);
  accuracy.keyframe_error = absoluteError(truth, estimates.keyframes);
  if (accuracy.final_error) {
    accuracy.relative_error =
        relativeError(truth, estimates.recomposed, accuracy.final_error->scale);
  }
  return accuracy;
}

}  // namespace glide::replay
