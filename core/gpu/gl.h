#pragma once

#include <GLES3/gl31.h>
// Extension tokens and types need the core header first.
#include <GLES2/gl2ext.h>

// The library never calls glGetError: pending errors are the app's. What can fail at creation is
// asked of the objects (GlBuffer::isComplete, GlTexture::isComplete, the status of programs); that
// no other call of ours raises an error is what the tests check with KHR_debug
// (docs/gl-contract.md).
