#pragma once

#include <map>
#include <string>
#include <vector>

namespace glide::test {

/// Values of GL state by name.
using GlSnapshot = std::map<std::string, std::vector<double>>;

/// All state of the current context that OpenGL ES 3.1 lets one query (chapter 20 of its
/// specification), and of 3.2 and GL_OES_EGL_image_external where they are: what is bound to every
/// binding point, with offsets; capabilities; raster, fragment and framebuffer state; pixel store;
/// the vertex arrays' attributes; active queries and transform feedback; hints. Changes nothing and
/// raises no error. What objects hold is not state of the context: see GlApp::objects.
GlSnapshot contextState();

/// Attributes, bindings and index buffer of the vertex array that is bound; part of contextState().
GlSnapshot vertexArrayState();

/// One line for each name whose values differ; empty when there is none.
std::string differences(const GlSnapshot& before, const GlSnapshot& after);

/// Adds `part` under names that begin with `prefix`.
void addAll(const std::string& prefix, const GlSnapshot& part, GlSnapshot* out);

/// Whether the current context is ES `major`.`minor` or newer.
bool isEs(int major, int minor);

/// Whether the current context has an extension.
bool hasGlExtension(const std::string& name);

}  // namespace glide::test
