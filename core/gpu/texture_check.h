#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/result.h"

namespace glide {

/// invalid_argument naming what is wrong with the texture object: none of the current context, of
/// another target or size than it says, or one that holds integers. When it is of another target,
/// the GL error is the app's. Inside of a ScopedGlState of that policy; leaves unit 0 active.
Status checkTextureObject(const Texture& texture, GlStatePolicy policy);

/// Whether the texture that is bound to GL_TEXTURE_2D of the active unit has no colours: its red is
/// the luma.
bool isBoundTextureGrey();

}  // namespace glide
