#pragma once

#include <GLES3/gl31.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace glide::gl_limits {

// The least that OpenGL ES 3.1 lets a device have (specification, tables 20.40 to 20.49).
inline constexpr int kGroupInvocations = 128;
inline constexpr int kGroupSize[] = {128, 128, 64};
inline constexpr int kGroupCount = 65535;
inline constexpr int kSharedBytes = 16384;
inline constexpr int kStorageBlocks = 4;
inline constexpr int kStorageBindings = 4;
inline constexpr int kImageUniforms = 4;
inline constexpr int kImageUnits = 4;
inline constexpr int kComputeTextures = 16;
inline constexpr int kUniformBlocks = 12;
inline constexpr int kUniformBindings = 36;
inline constexpr int kTextureSize = 2048;
inline constexpr std::int64_t kStorageBytes = std::int64_t{1} << 27;

/// What the floor device answers to glGetIntegerv(pname): the floor, or nothing where the driver's
/// own value stands.
std::optional<int> floorOf(GLenum pname);

/// Whether the floor device hides an extension of the driver: those that the library uses where
/// they are there and does without where not. (External textures stay: only fragment shaders sample
/// them then.)
bool isHidden(std::string_view extension);

}  // namespace glide::gl_limits
