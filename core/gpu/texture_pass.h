#pragma once

#include "gpu/compute_program.h"
#include "gpu/external_draw.h"
#include "gpu/gl_caps.h"
#include "gpu/gl_state.h"
#include "gpu/texture_placement.h"

#include <optional>
#include <string>

namespace glide {

/// What of unit 0 other kernels would stumble over: a sampler object, and an external texture.
struct TextureBinding {
  TextureBinding() = default;
  ~TextureBinding() { glBindSampler(0, 0); }
  TextureBinding(const TextureBinding&) = delete;
  TextureBinding& operator=(const TextureBinding&) = delete;

  std::optional<ScopedTextureBinding> external;
};

/// A kernel of shaders/ that includes texture_source.glsl.
struct TextureKernel {
  std::string shader;
  int group_size = 64;      ///< 32, 64 or 128
  ProgramCache programs{};  ///< where it is taken from and left
};

/// A compute kernel over the frame that an app's texture shows (shaders/texture_source.glsl). What
/// a kind of texture needs is built when the first of it comes: most apps pass one kind, or none.
/// An external texture is sampled by the kernel where ESSL 3 can do that, else drawn into one of
/// ours first (ExternalDraw). All calls are made inside of a ScopedGlState.
class TexturePass {
 public:
  /// Makes no GL call.
  TexturePass(TextureKernel kernel, const GlCaps& caps, FrameSize frame);

  /// Whether prepare() has seen this texture last, and it still exists: a cheap question.
  bool isPrepared(const Texture& texture) const;
  /// Looks at the texture, which passed checkPlacement, and builds what it needs.
  /// invalid_argument or unsupported naming what is wrong with the texture, gl when a shader does
  /// not build.
  Status prepare(const Texture& texture, GlStatePolicy policy);

  /// Binds the texture that was prepared to unit 0, and the program with its uniforms; the caller
  /// dispatches before `binding` dies.
  void bind(const Texture& texture, GlStatePolicy policy, TextureBinding* binding) const;

  FrameSize frame() const { return frame_; }
  int groupSize() const { return kernel_.group_size; }
  void abandon();

 private:
  Status prepareProgram(GLenum target);
  Status prepareSamplers();
  void bindPlain(const Texture& texture) const;
  void bindExternal(const Texture& texture, GlStatePolicy policy, TextureBinding* binding) const;
  void bindDrawn(const Texture& texture, GlStatePolicy policy) const;

  TextureKernel kernel_;
  bool samples_external_, draws_external_;  ///< which way to external textures there is
  FrameSize frame_;
  std::optional<ComputeProgram> plain_, external_;
  std::optional<ExternalDraw> draw_;
  GlSampler nearest_, linear_;
  Texture prepared_;
};

}  // namespace glide
