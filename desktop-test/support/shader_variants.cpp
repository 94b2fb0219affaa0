#include "support/shader_variants.h"

#include <algorithm>
#include <set>

namespace glide::test {
namespace {

/// A define and the values that it takes.
struct Axis {
  std::string_view define;
  std::vector<int> values;
};

/// A shader and the defines that it needs, which vary independently.
struct Family {
  std::string_view shader;
  std::vector<Axis> axes;
};

/// THE list.
std::vector<Family> families() {
  const Axis group_size{"GROUP_SIZE", {32, 64, 128}};  // GpuTuning::group_size
  const Axis group_rows{"GROUP_ROWS", {1, 2, 4}};      // of 32 invocations: the same group sizes
  const Axis external{"EXTERNAL_TEXTURE", {0, 1}};     // TexturePass
  const Axis patch_size{"PATCH_SIZE", {7, 11}};        // of TUM's and EuRoC's images in the paper
  const Axis camera_model{"CAMERA_MODEL", {0, 1, 2}};  // alignDefines()
  return {{"align_coarse.comp", {group_size, patch_size, camera_model}},
          {"align_precompute.comp", {group_size, patch_size, camera_model}},
          {"align_residual.comp", {group_size, patch_size, camera_model}},
          {"align_solve.comp", {group_size, patch_size}},
          {"luma_to_float.comp", {group_rows}},
          {"paper_hessian.comp", {group_size, patch_size}},
          {"paper_precompute.comp", {group_size, patch_size, camera_model}},
          {"paper_reduce.comp", {group_size, patch_size}},
          {"paper_residual.comp", {group_size, patch_size, camera_model}},
          {"paper_solve.comp", {group_size, patch_size}},
          {"texture_to_bytes.comp", {group_rows, external}},
          {"texture_to_float.comp", {group_rows, external}},
          {"external_to_grey.vert", {}},
          {"external_to_grey.frag", {}},
          {"render_camera_external.vert", {}},
          {"render_camera_external.frag", {}},
          {"render_camera_ink.vert", {}},
          {"render_camera_ink.frag", {}},
          {"render_camera_picture.vert", {}},
          {"render_camera_picture.frag", {}},
          {"render_map_frusta.vert", {}},
          {"render_map_lines.vert", {}},
          {"render_map_panel.vert", {}},
          {"render_map_panel.frag", {}},
          {"render_map_points.vert", {}},
          {"render_map_points.frag", {}},
          {"render_map_stroke.frag", {}},
          {"pyramid_blur_columns.comp", {group_rows}},
          {"pyramid_blur_rows.comp", {group_rows}},
          {"pyramid_strip.comp", {group_rows}},
          {"pyramid_tile.comp", {group_rows}}};
}

/// All combinations of the values of `axes`.
std::vector<ShaderDefines> combinations(const std::vector<Axis>& axes) {
  std::vector<ShaderDefines> all{{}};
  for (const Axis& axis : axes) {
    std::vector<ShaderDefines> longer;
    for (const ShaderDefines& head : all) {
      for (const int value : axis.values) {
        longer.push_back(head);
        longer.back().push_back({std::string(axis.define), value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

}  // namespace

std::vector<ShaderVariant> shaderVariants() {
  std::vector<ShaderVariant> variants;
  for (const Family& family : families()) {
    for (ShaderDefines& defines : combinations(family.axes)) {
      variants.push_back({family.shader, std::move(defines)});
    }
  }
  return variants;
}

std::string variantName(const ShaderVariant& variant) {
  std::string name(variant.shader);
  for (const ShaderDefine& define : variant.defines) {
    name += " " + define.name + "=" + std::to_string(define.value);
  }
  return name;
}

bool isShaderStage(std::string_view name) {
  constexpr std::string_view kSuffixes[] = {".comp", ".vert", ".frag"};
  return std::any_of(std::begin(kSuffixes), std::end(kSuffixes), [&](std::string_view suffix) {
    return name.size() > suffix.size() && name.substr(name.size() - suffix.size()) == suffix;
  });
}

std::vector<std::string> missingVariants(std::span<const EmbeddedShader> library) {
  std::set<std::string> listed;
  for (const Family& family : families()) listed.emplace(family.shader);
  std::vector<std::string> missing;
  for (const EmbeddedShader& shader : library) {
    if (isShaderStage(shader.name) && listed.erase(std::string(shader.name)) == 0) {
      missing.push_back(std::string(shader.name) + " has no variants");
    }
  }
  for (const std::string& name : listed) missing.push_back(name + " is listed but not there");
  return missing;
}

}  // namespace glide::test
