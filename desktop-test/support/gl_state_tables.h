#pragma once

// The 3.2 header names what an ES 3.2 context has more; the functions are called only there.
#include <GLES3/gl32.h>
// Extension tokens and types need the core header first.
#include <GLES2/gl2ext.h>

namespace glide::test {

/// One piece of state: its name in messages, the token, how many values it has.
struct StateQuery {
  const char* name;
  GLenum query;
  int count;
};

/// State of numbered binding points; `count_query` asks how many there are.
struct IndexedState {
  const char* name;
  GLenum query, count_query;
};

/// For glGetInteger64v.
inline constexpr StateQuery kIntegerStates[] = {
    {"current program", GL_CURRENT_PROGRAM, 1},
    {"program pipeline binding", GL_PROGRAM_PIPELINE_BINDING, 1},
    {"active texture", GL_ACTIVE_TEXTURE, 1},
    {"vertex array binding", GL_VERTEX_ARRAY_BINDING, 1},
    {"array buffer binding", GL_ARRAY_BUFFER_BINDING, 1},
    {"element array buffer binding", GL_ELEMENT_ARRAY_BUFFER_BINDING, 1},
    {"draw indirect buffer binding", GL_DRAW_INDIRECT_BUFFER_BINDING, 1},
    {"dispatch indirect buffer binding", GL_DISPATCH_INDIRECT_BUFFER_BINDING, 1},
    {"copy read buffer binding", GL_COPY_READ_BUFFER_BINDING, 1},
    {"copy write buffer binding", GL_COPY_WRITE_BUFFER_BINDING, 1},
    {"pixel pack buffer binding", GL_PIXEL_PACK_BUFFER_BINDING, 1},
    {"pixel unpack buffer binding", GL_PIXEL_UNPACK_BUFFER_BINDING, 1},
    {"uniform buffer binding", GL_UNIFORM_BUFFER_BINDING, 1},
    {"shader storage buffer binding", GL_SHADER_STORAGE_BUFFER_BINDING, 1},
    {"atomic counter buffer binding", GL_ATOMIC_COUNTER_BUFFER_BINDING, 1},
    {"transform feedback buffer binding", GL_TRANSFORM_FEEDBACK_BUFFER_BINDING, 1},
    {"transform feedback binding", GL_TRANSFORM_FEEDBACK_BINDING, 1},
    {"transform feedback active", GL_TRANSFORM_FEEDBACK_ACTIVE, 1},
    {"transform feedback paused", GL_TRANSFORM_FEEDBACK_PAUSED, 1},
    {"draw framebuffer binding", GL_DRAW_FRAMEBUFFER_BINDING, 1},
    {"read framebuffer binding", GL_READ_FRAMEBUFFER_BINDING, 1},
    {"renderbuffer binding", GL_RENDERBUFFER_BINDING, 1},
    {"read buffer", GL_READ_BUFFER, 1},
    {"draw buffer0", GL_DRAW_BUFFER0, 1},
    {"draw buffer1", GL_DRAW_BUFFER1, 1},
    {"draw buffer2", GL_DRAW_BUFFER2, 1},
    {"draw buffer3", GL_DRAW_BUFFER3, 1},
    {"viewport", GL_VIEWPORT, 4},
    {"scissor box", GL_SCISSOR_BOX, 4},
    {"cull face mode", GL_CULL_FACE_MODE, 1},
    {"front face", GL_FRONT_FACE, 1},
    {"stencil func", GL_STENCIL_FUNC, 1},
    {"stencil ref", GL_STENCIL_REF, 1},
    {"stencil value mask", GL_STENCIL_VALUE_MASK, 1},
    {"stencil fail", GL_STENCIL_FAIL, 1},
    {"stencil pass depth fail", GL_STENCIL_PASS_DEPTH_FAIL, 1},
    {"stencil pass depth pass", GL_STENCIL_PASS_DEPTH_PASS, 1},
    {"stencil back func", GL_STENCIL_BACK_FUNC, 1},
    {"stencil back ref", GL_STENCIL_BACK_REF, 1},
    {"stencil back value mask", GL_STENCIL_BACK_VALUE_MASK, 1},
    {"stencil back fail", GL_STENCIL_BACK_FAIL, 1},
    {"stencil back pass depth fail", GL_STENCIL_BACK_PASS_DEPTH_FAIL, 1},
    {"stencil back pass depth pass", GL_STENCIL_BACK_PASS_DEPTH_PASS, 1},
    {"stencil writemask", GL_STENCIL_WRITEMASK, 1},
    {"stencil back writemask", GL_STENCIL_BACK_WRITEMASK, 1},
    {"stencil clear value", GL_STENCIL_CLEAR_VALUE, 1},
    {"depth func", GL_DEPTH_FUNC, 1},
    {"depth writemask", GL_DEPTH_WRITEMASK, 1},
    {"color writemask", GL_COLOR_WRITEMASK, 4},
    {"blend src rgb", GL_BLEND_SRC_RGB, 1},
    {"blend dst rgb", GL_BLEND_DST_RGB, 1},
    {"blend src alpha", GL_BLEND_SRC_ALPHA, 1},
    {"blend dst alpha", GL_BLEND_DST_ALPHA, 1},
    {"blend equation rgb", GL_BLEND_EQUATION_RGB, 1},
    {"blend equation alpha", GL_BLEND_EQUATION_ALPHA, 1},
    {"sample coverage invert", GL_SAMPLE_COVERAGE_INVERT, 1},
    {"unpack alignment", GL_UNPACK_ALIGNMENT, 1},
    {"unpack row length", GL_UNPACK_ROW_LENGTH, 1},
    {"unpack skip rows", GL_UNPACK_SKIP_ROWS, 1},
    {"unpack skip pixels", GL_UNPACK_SKIP_PIXELS, 1},
    {"unpack image height", GL_UNPACK_IMAGE_HEIGHT, 1},
    {"unpack skip images", GL_UNPACK_SKIP_IMAGES, 1},
    {"pack alignment", GL_PACK_ALIGNMENT, 1},
    {"pack row length", GL_PACK_ROW_LENGTH, 1},
    {"pack skip rows", GL_PACK_SKIP_ROWS, 1},
    {"pack skip pixels", GL_PACK_SKIP_PIXELS, 1},
    {"generate mipmap hint", GL_GENERATE_MIPMAP_HINT, 1},
    {"fragment shader derivative hint", GL_FRAGMENT_SHADER_DERIVATIVE_HINT, 1},
};

/// For glGetFloatv.
inline constexpr StateQuery kFloatStates[] = {
    {"depth range", GL_DEPTH_RANGE, 2},
    {"depth clear value", GL_DEPTH_CLEAR_VALUE, 1},
    {"color clear value", GL_COLOR_CLEAR_VALUE, 4},
    {"blend color", GL_BLEND_COLOR, 4},
    {"line width", GL_LINE_WIDTH, 1},
    {"polygon offset factor", GL_POLYGON_OFFSET_FACTOR, 1},
    {"polygon offset units", GL_POLYGON_OFFSET_UNITS, 1},
    {"sample coverage value", GL_SAMPLE_COVERAGE_VALUE, 1},
};

/// For glIsEnabled.
inline constexpr StateQuery kCapabilities[] = {
    {"blend", GL_BLEND, 1},
    {"cull face", GL_CULL_FACE, 1},
    {"depth test", GL_DEPTH_TEST, 1},
    {"dither", GL_DITHER, 1},
    {"polygon offset fill", GL_POLYGON_OFFSET_FILL, 1},
    {"primitive restart fixed index", GL_PRIMITIVE_RESTART_FIXED_INDEX, 1},
    {"rasterizer discard", GL_RASTERIZER_DISCARD, 1},
    {"sample alpha to coverage", GL_SAMPLE_ALPHA_TO_COVERAGE, 1},
    {"sample coverage", GL_SAMPLE_COVERAGE, 1},
    {"sample mask", GL_SAMPLE_MASK, 1},
    {"scissor test", GL_SCISSOR_TEST, 1},
    {"stencil test", GL_STENCIL_TEST, 1},
};

/// Of OpenGL ES 3.2, for glGetFloatv.
inline constexpr StateQuery kStates32[] = {
    {"sample shading", GL_SAMPLE_SHADING, 1},
    {"min sample shading value", GL_MIN_SAMPLE_SHADING_VALUE, 1},
    {"patch vertices", GL_PATCH_VERTICES, 1},
    {"primitive bounding box", GL_PRIMITIVE_BOUNDING_BOX, 8},
    {"texture buffer binding", GL_TEXTURE_BUFFER_BINDING, 1},
    {"debug output", GL_DEBUG_OUTPUT, 1},
    {"debug output synchronous", GL_DEBUG_OUTPUT_SYNCHRONOUS, 1},
    {"debug group stack depth", GL_DEBUG_GROUP_STACK_DEPTH, 1},
};

/// Of OpenGL ES 3.2, of each draw buffer.
inline constexpr StateQuery kDrawBufferStates[] = {
    {"blend src rgb", GL_BLEND_SRC_RGB, 1},
    {"blend dst rgb", GL_BLEND_DST_RGB, 1},
    {"blend src alpha", GL_BLEND_SRC_ALPHA, 1},
    {"blend dst alpha", GL_BLEND_DST_ALPHA, 1},
    {"blend equation rgb", GL_BLEND_EQUATION_RGB, 1},
    {"blend equation alpha", GL_BLEND_EQUATION_ALPHA, 1},
};

/// Of each texture unit.
inline constexpr StateQuery kTextureBindings[] = {
    {"texture binding 2d", GL_TEXTURE_BINDING_2D, 1},
    {"texture binding 3d", GL_TEXTURE_BINDING_3D, 1},
    {"texture binding 2d array", GL_TEXTURE_BINDING_2D_ARRAY, 1},
    {"texture binding cube map", GL_TEXTURE_BINDING_CUBE_MAP, 1},
    {"texture binding 2d multisample", GL_TEXTURE_BINDING_2D_MULTISAMPLE, 1},
    {"sampler binding", GL_SAMPLER_BINDING, 1},
};
inline constexpr StateQuery kTextureBindings32[] = {
    {"texture binding cube map array", GL_TEXTURE_BINDING_CUBE_MAP_ARRAY, 1},
    {"texture binding buffer", GL_TEXTURE_BINDING_BUFFER, 1},
    {"texture binding 2d multisample array", GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY, 1},
};

/// Of each attribute of the vertex array, for glGetVertexAttribiv.
inline constexpr StateQuery kAttributeStates[] = {
    {"vertex attrib array enabled", GL_VERTEX_ATTRIB_ARRAY_ENABLED, 1},
    {"vertex attrib array size", GL_VERTEX_ATTRIB_ARRAY_SIZE, 1},
    {"vertex attrib array stride", GL_VERTEX_ATTRIB_ARRAY_STRIDE, 1},
    {"vertex attrib array type", GL_VERTEX_ATTRIB_ARRAY_TYPE, 1},
    {"vertex attrib array normalized", GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, 1},
    {"vertex attrib array integer", GL_VERTEX_ATTRIB_ARRAY_INTEGER, 1},
    {"vertex attrib array divisor", GL_VERTEX_ATTRIB_ARRAY_DIVISOR, 1},
    {"vertex attrib array buffer binding", GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, 1},
    {"vertex attrib binding", GL_VERTEX_ATTRIB_BINDING, 1},
    {"vertex attrib relative offset", GL_VERTEX_ATTRIB_RELATIVE_OFFSET, 1},
};

/// Targets of queries that may be active.
inline constexpr StateQuery kQueryTargets[] = {
    {"any samples passed", GL_ANY_SAMPLES_PASSED, 1},
    {"any samples passed conservative", GL_ANY_SAMPLES_PASSED_CONSERVATIVE, 1},
    {"transform feedback primitives written", GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, 1},
};

inline constexpr IndexedState kIndexedStates[] = {
    {"shader storage buffer binding",
     GL_SHADER_STORAGE_BUFFER_BINDING,
     GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {"shader storage buffer start",
     GL_SHADER_STORAGE_BUFFER_START,
     GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {"shader storage buffer size",
     GL_SHADER_STORAGE_BUFFER_SIZE,
     GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS},
    {"uniform buffer binding", GL_UNIFORM_BUFFER_BINDING, GL_MAX_UNIFORM_BUFFER_BINDINGS},
    {"uniform buffer start", GL_UNIFORM_BUFFER_START, GL_MAX_UNIFORM_BUFFER_BINDINGS},
    {"uniform buffer size", GL_UNIFORM_BUFFER_SIZE, GL_MAX_UNIFORM_BUFFER_BINDINGS},
    {"atomic counter buffer binding",
     GL_ATOMIC_COUNTER_BUFFER_BINDING,
     GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS},
    {"atomic counter buffer start",
     GL_ATOMIC_COUNTER_BUFFER_START,
     GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS},
    {"atomic counter buffer size",
     GL_ATOMIC_COUNTER_BUFFER_SIZE,
     GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS},
    {"transform feedback buffer binding",
     GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
     GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS},
    {"transform feedback buffer start",
     GL_TRANSFORM_FEEDBACK_BUFFER_START,
     GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS},
    {"transform feedback buffer size",
     GL_TRANSFORM_FEEDBACK_BUFFER_SIZE,
     GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS},
    {"image binding name", GL_IMAGE_BINDING_NAME, GL_MAX_IMAGE_UNITS},
    {"image binding level", GL_IMAGE_BINDING_LEVEL, GL_MAX_IMAGE_UNITS},
    {"image binding layered", GL_IMAGE_BINDING_LAYERED, GL_MAX_IMAGE_UNITS},
    {"image binding layer", GL_IMAGE_BINDING_LAYER, GL_MAX_IMAGE_UNITS},
    {"image binding access", GL_IMAGE_BINDING_ACCESS, GL_MAX_IMAGE_UNITS},
    {"image binding format", GL_IMAGE_BINDING_FORMAT, GL_MAX_IMAGE_UNITS},
    {"vertex binding offset", GL_VERTEX_BINDING_OFFSET, GL_MAX_VERTEX_ATTRIB_BINDINGS},
    {"vertex binding stride", GL_VERTEX_BINDING_STRIDE, GL_MAX_VERTEX_ATTRIB_BINDINGS},
    {"vertex binding divisor", GL_VERTEX_BINDING_DIVISOR, GL_MAX_VERTEX_ATTRIB_BINDINGS},
    {"vertex binding buffer", GL_VERTEX_BINDING_BUFFER, GL_MAX_VERTEX_ATTRIB_BINDINGS},
};

}  // namespace glide::test
