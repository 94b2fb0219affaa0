#pragma once

#include "photometric/aligner.h"

#include "geometry/camera_model.h"

#include "glide/config.h"
#include "glide/result.h"
#include "glide/session.h"

#include <memory>

namespace glide {

/// An aligner and what it runs on.
struct ChosenAligner {
  std::unique_ptr<Aligner> aligner;
  BackendInfo info;
};

/// Backend::gles needs a current ES 3.1 context (missing_context without one, unsupported with
/// another); Backend::automatic takes one that is hardware, else the CPU.
Result<ChosenAligner> chooseAligner(const Config& config, const CameraModel& camera);

}  // namespace glide
