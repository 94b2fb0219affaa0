#include "support/gl_snapshot.h"

#include "support/gl_state_tables.h"

#include <sstream>

namespace glide::test {
namespace {

std::vector<double> integers(GLenum query, int count) {
  std::vector<GLint64> values(static_cast<std::size_t>(count));
  glGetInteger64v(query, values.data());
  return {values.begin(), values.end()};
}

std::vector<double> floats(GLenum query, int count) {
  std::vector<GLfloat> values(static_cast<std::size_t>(count));
  glGetFloatv(query, values.data());
  return {values.begin(), values.end()};
}

double indexed(GLenum query, GLuint index) {
  GLint64 value = 0;
  glGetInteger64i_v(query, index, &value);
  return static_cast<double>(value);
}

int limit(GLenum query) {
  GLint value = 0;
  glGetIntegerv(query, &value);
  return value;
}

std::string numbered(const std::string& name, int index) {
  return name + "[" + std::to_string(index) + "]";
}

void addPlain(GlSnapshot* out) {
  for (const StateQuery& q : kIntegerStates) (*out)[q.name] = integers(q.query, q.count);
  for (const StateQuery& q : kFloatStates) (*out)[q.name] = floats(q.query, q.count);
  for (const StateQuery& q : kCapabilities) (*out)[q.name] = {glIsEnabled(q.query) ? 1.0 : 0.0};
  if (!isEs(3, 2)) return;
  for (const StateQuery& q : kStates32) (*out)[q.name] = floats(q.query, q.count);
  for (int i = 0; i < limit(GL_MAX_DRAW_BUFFERS); ++i) {
    const auto index = static_cast<GLuint>(i);
    (*out)[numbered("blend of draw buffer", i)] = {glIsEnabledi(GL_BLEND, index) ? 1.0 : 0.0};
    GLboolean mask[4] = {};
    glGetBooleani_v(GL_COLOR_WRITEMASK, index, mask);
    (*out)[numbered("colour mask of draw buffer", i)] = {mask, mask + 4};
    for (const StateQuery& q : kDrawBufferStates)
      (*out)[numbered(q.name, i)] = {indexed(q.query, index)};
  }
}

void addIndexed(GlSnapshot* out) {
  for (const IndexedState& state : kIndexedStates) {
    for (int i = 0; i < limit(state.count_query); ++i)
      (*out)[numbered(state.name, i)] = {indexed(state.query, static_cast<GLuint>(i))};
  }
  GLint mask_words = limit(GL_MAX_SAMPLE_MASK_WORDS);
  for (GLint i = 0; i < mask_words; ++i)
    (*out)[numbered("sample mask", i)] = {indexed(GL_SAMPLE_MASK_VALUE, static_cast<GLuint>(i))};
}

void addTextureUnits(GlSnapshot* out) {
  const GLint active = limit(GL_ACTIVE_TEXTURE);
  const int units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  const bool external = hasGlExtension("GL_OES_EGL_image_external");
  for (int unit = 0; unit < units; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    for (const StateQuery& q : kTextureBindings)
      (*out)[numbered(q.name, unit)] = integers(q.query, 1);
    if (isEs(3, 2)) {
      for (const StateQuery& q : kTextureBindings32)
        (*out)[numbered(q.name, unit)] = integers(q.query, 1);
    }
    if (external)
      (*out)[numbered("external texture", unit)] = integers(GL_TEXTURE_BINDING_EXTERNAL_OES, 1);
  }
  glActiveTexture(static_cast<GLenum>(active));
}

void addAttributes(GlSnapshot* out) {
  for (int i = 0; i < limit(GL_MAX_VERTEX_ATTRIBS); ++i) {
    const auto index = static_cast<GLuint>(i);
    for (const StateQuery& q : kAttributeStates) {
      GLint value = 0;
      glGetVertexAttribiv(index, q.query, &value);
      (*out)[numbered(q.name, i)] = {static_cast<double>(value)};
    }
    GLfloat current[4] = {};
    glGetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, current);
    (*out)[numbered("attribute value", i)] = {current, current + 4};
    void* pointer = nullptr;
    glGetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    (*out)[numbered("attribute pointer", i)] = {
        static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer))};
  }
}

void addActiveQueries(GlSnapshot* out) {
  for (const StateQuery& q : kQueryTargets) {
    GLint name = 0;
    glGetQueryiv(q.query, GL_CURRENT_QUERY, &name);
    (*out)[q.name] = {static_cast<double>(name)};
  }
}

}  // namespace

GlSnapshot vertexArrayState() {
  GlSnapshot out;
  addAttributes(&out);
  for (const GLenum query : {GL_VERTEX_BINDING_OFFSET,
                             GL_VERTEX_BINDING_STRIDE,
                             GL_VERTEX_BINDING_DIVISOR,
                             GL_VERTEX_BINDING_BUFFER}) {
    for (int i = 0; i < limit(GL_MAX_VERTEX_ATTRIB_BINDINGS); ++i)
      out[numbered("binding query " + std::to_string(query), i)] = {
          indexed(query, static_cast<GLuint>(i))};
  }
  out["element array buffer binding"] = integers(GL_ELEMENT_ARRAY_BUFFER_BINDING, 1);
  return out;
}

GlSnapshot contextState() {
  GlSnapshot out;
  addPlain(&out);
  addIndexed(&out);
  addTextureUnits(&out);
  addAttributes(&out);
  addActiveQueries(&out);
  return out;
}

std::string differences(const GlSnapshot& before, const GlSnapshot& after) {
  std::ostringstream text;
  const auto print = [&text](const std::vector<double>& values) {
    for (const double value : values) text << ' ' << value;
  };
  for (const auto& [name, values] : before) {
    const auto found = after.find(name);
    const std::vector<double> now = found == after.end() ? std::vector<double>() : found->second;
    if (now == values) continue;
    text << name << ": was";
    print(values);
    text << ", is";
    print(now);
    text << '\n';
  }
  if (before.size() != after.size())
    text << before.size() << " values before, " << after.size() << " after\n";
  return text.str();
}

void addAll(const std::string& prefix, const GlSnapshot& part, GlSnapshot* out) {
  for (const auto& [name, values] : part) (*out)[prefix + name] = values;
}

bool isEs(int major, int minor) {
  const GLint has_major = limit(GL_MAJOR_VERSION);
  return has_major > major || (has_major == major && limit(GL_MINOR_VERSION) >= minor);
}

bool hasGlExtension(const std::string& name) {
  for (GLint i = 0; i < limit(GL_NUM_EXTENSIONS); ++i) {
    const GLubyte* text = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (text != nullptr && name == reinterpret_cast<const char*>(text)) return true;
  }
  return false;
}

}  // namespace glide::test
