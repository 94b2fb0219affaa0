#pragma once

#include "glide/config.h"
#include "glide/types.h"

#include <array>
#include <optional>
#include <string_view>

namespace glide {

/// One value of an enum with the name that files, logs and command lines use for it.
template <class E>
struct EnumName {
  E value;
  std::string_view name;
};

/// The names of an enum, found by argument type: enumNames(Backend{}).
constexpr std::array<EnumName<Backend>, 3> enumNames(Backend) {
  return {{{Backend::automatic, "auto"}, {Backend::gles, "gles"}, {Backend::cpu, "cpu"}}};
}
constexpr std::array<EnumName<TrackerMode>, 2> enumNames(TrackerMode) {
  return {{{TrackerMode::hybrid, "hybrid"}, {TrackerMode::indirect, "indirect"}}};
}
constexpr std::array<EnumName<Execution>, 2> enumNames(Execution) {
  return {{{Execution::threaded, "threaded"}, {Execution::inline_, "inline"}}};
}
constexpr std::array<EnumName<SessionMode>, 2> enumNames(SessionMode) {
  return {{{SessionMode::slam, "slam"}, {SessionMode::localization_only, "localization_only"}}};
}
constexpr std::array<EnumName<ReportPoints>, 3> enumNames(ReportPoints) {
  return {
      {{ReportPoints::off, "off"}, {ReportPoints::indirect, "indirect"}, {ReportPoints::on, "on"}}};
}
constexpr std::array<EnumName<CalibrationRefinement>, 2> enumNames(CalibrationRefinement) {
  return {{{CalibrationRefinement::on, "on"}, {CalibrationRefinement::off, "off"}}};
}
constexpr std::array<EnumName<LoopClosing>, 2> enumNames(LoopClosing) {
  return {{{LoopClosing::on, "on"}, {LoopClosing::off, "off"}}};
}
constexpr std::array<EnumName<GlStatePolicy>, 3> enumNames(GlStatePolicy) {
  return {{{GlStatePolicy::preserve, "preserve"},
           {GlStatePolicy::reset, "reset"},
           {GlStatePolicy::none, "none"}}};
}
constexpr std::array<EnumName<GlCreation>, 2> enumNames(GlCreation) {
  return {{{GlCreation::at_create, "at_create"}, {GlCreation::at_first_update, "at_first_update"}}};
}
constexpr std::array<EnumName<GpuPlanChoice>, 3> enumNames(GpuPlanChoice) {
  return {{{GpuPlanChoice::automatic, "auto"},
           {GpuPlanChoice::fused, "fused"},
           {GpuPlanChoice::paper, "paper"}}};
}
constexpr std::array<EnumName<GpuAutotune>, 2> enumNames(GpuAutotune) {
  return {{{GpuAutotune::on, "on"}, {GpuAutotune::off, "off"}}};
}
constexpr std::array<EnumName<PhotometricModel>, 2> enumNames(PhotometricModel) {
  return {{{PhotometricModel::none, "none"}, {PhotometricModel::gain_bias, "gain_bias"}}};
}
constexpr std::array<EnumName<HessianMode>, 2> enumNames(HessianMode) {
  return {{{HessianMode::robust, "robust"}, {HessianMode::constant, "constant"}}};
}
constexpr std::array<EnumName<DistortionModel>, 3> enumNames(DistortionModel) {
  return {{{DistortionModel::none, "none"},
           {DistortionModel::radial_tangential, "radial_tangential"},
           {DistortionModel::kannala_brandt4, "kannala_brandt4"}}};
}
constexpr std::array<EnumName<TrackingState>, 4> enumNames(TrackingState) {
  return {{{TrackingState::initializing, "initializing"},
           {TrackingState::tracking, "tracking"},
           {TrackingState::lost, "lost"},
           {TrackingState::paused, "paused"}}};
}
constexpr std::array<EnumName<TrackerKind>, 3> enumNames(TrackerKind) {
  return {{{TrackerKind::none, "none"},
           {TrackerKind::direct, "direct"},
           {TrackerKind::indirect, "indirect"}}};
}
constexpr std::array<EnumName<StageTimer>, 3> enumNames(StageTimer) {
  return {{{StageTimer::cpu, "cpu"}, {StageTimer::sync, "sync"}, {StageTimer::query, "query"}}};
}
constexpr std::array<EnumName<SwitchReason>, 9> enumNames(SwitchReason) {
  return {{{SwitchReason::none, "none"},
           {SwitchReason::no_reference, "no_reference"},
           {SwitchReason::solve_failed, "solve_failed"},
           {SwitchReason::too_few_visible, "too_few_visible"},
           {SwitchReason::photometric_error, "photometric_error"},
           {SwitchReason::baseline, "baseline"},
           {SwitchReason::rotation, "rotation"},
           {SwitchReason::max_direct_frames, "max_direct_frames"},
           {SwitchReason::disabled, "disabled"}}};
}
constexpr std::array<EnumName<InitializationStatus>, 6> enumNames(InitializationStatus) {
  return {{{InitializationStatus::done, "done"},
           {InitializationStatus::waiting_for_image, "waiting_for_image"},
           {InitializationStatus::too_few_matches, "too_few_matches"},
           {InitializationStatus::too_little_motion, "too_little_motion"},
           {InitializationStatus::pure_rotation, "pure_rotation"},
           {InitializationStatus::ambiguous, "ambiguous"}}};
}

/// Name of a value; "?" for a number that is no value of the enum.
template <class E>
constexpr std::string_view enumName(E value) {
  for (const EnumName<E>& entry : enumNames(E{})) {
    if (entry.value == value) return entry.name;
  }
  return "?";
}

/// The value of that name, if there is one.
template <class E>
constexpr std::optional<E> enumFromName(std::string_view name) {
  for (const EnumName<E>& entry : enumNames(E{})) {
    if (entry.name == name) return entry.value;
  }
  return std::nullopt;
}

}  // namespace glide
