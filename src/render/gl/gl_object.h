#pragma once

#include <utility>

#include "render/gl/gl_functions.h"

namespace synthetic_dataset::render {

/// Owns one OpenGL name and deletes it. Move-only; the context has to outlive it.
template <class Kind>
class GlObject {
 public:
  GlObject() = default;
  GlObject(const GlFunctions& gl, GLuint name) : gl_(&gl), name_(name) {}
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  ~GlObject() {
    if (name_ != 0) Kind::remove(*gl_, name_);
  }

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  const GlFunctions* gl_ = nullptr;
  GLuint name_ = 0;
};

struct BufferKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteBuffers(1, &name); }
};
struct VertexArrayKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteVertexArrays(1, &name); }
};
struct TextureKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteTextures(1, &name); }
};
struct FramebufferKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteFramebuffers(1, &name); }
};
struct ProgramKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteProgram(name); }
};
struct ShaderKind {
  static void remove(const GlFunctions& gl, GLuint name) { gl.DeleteShader(name); }
};

using GlBuffer = GlObject<BufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;
using GlTexture = GlObject<TextureKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlProgram = GlObject<ProgramKind>;
using GlShader = GlObject<ShaderKind>;

[[nodiscard]] inline GlBuffer makeBuffer(const GlFunctions& gl) {
  GLuint name = 0;
  gl.CreateBuffers(1, &name);
  return {gl, name};
}
[[nodiscard]] inline GlVertexArray makeVertexArray(const GlFunctions& gl) {
  GLuint name = 0;
  gl.CreateVertexArrays(1, &name);
  return {gl, name};
}
[[nodiscard]] inline GlTexture makeTexture(const GlFunctions& gl, GLenum target) {
  GLuint name = 0;
  gl.CreateTextures(target, 1, &name);
  return {gl, name};
}
[[nodiscard]] inline GlFramebuffer makeFramebuffer(const GlFunctions& gl) {
  GLuint name = 0;
  gl.CreateFramebuffers(1, &name);
  return {gl, name};
}

}  // namespace synthetic_dataset::render
