#include "render/gl/gl_functions.h"

#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

/// Fills in one entry point, and records its name if it is missing.
class Loader {
 public:
  explicit Loader(void* (*load)(const char* name)) : load_(load) {}

  template <class Function>
  void operator()(Function& function, const char* name) {
    function = reinterpret_cast<Function>(load_(name));
    if (function == nullptr) missing_ += (missing_.empty() ? "" : ", ") + std::string(name);
  }

  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  void* (*load_)(const char* name);
  std::string missing_;
};

}  // namespace

GlFunctions::GlFunctions(void* (*load)(const char* name)) {
  Loader fill(load);
  fill(GetString, "glGetString");
  fill(Enable, "glEnable");
  fill(Disable, "glDisable");
  fill(Viewport, "glViewport");
  fill(Scissor, "glScissor");
  fill(DepthFunc, "glDepthFunc");
  fill(DepthMask, "glDepthMask");
  fill(FrontFace, "glFrontFace");
  fill(StencilFunc, "glStencilFunc");
  fill(StencilOp, "glStencilOp");
  fill(StencilMask, "glStencilMask");
  fill(BlendFuncSeparate, "glBlendFuncSeparate");
  fill(ClipControl, "glClipControl");
  fill(PixelStorei, "glPixelStorei");
  fill(Flush, "glFlush");
  fill(ReadPixels, "glReadPixels");
  fill(DrawArraysInstanced, "glDrawArraysInstanced");
  fill(DrawElements, "glDrawElements");
  fill(CreateBuffers, "glCreateBuffers");
  fill(DeleteBuffers, "glDeleteBuffers");
  fill(NamedBufferStorage, "glNamedBufferStorage");
  fill(CreateVertexArrays, "glCreateVertexArrays");
  fill(DeleteVertexArrays, "glDeleteVertexArrays");
  fill(BindVertexArray, "glBindVertexArray");
  fill(VertexArrayVertexBuffer, "glVertexArrayVertexBuffer");
  fill(VertexArrayElementBuffer, "glVertexArrayElementBuffer");
  fill(EnableVertexArrayAttrib, "glEnableVertexArrayAttrib");
  fill(VertexArrayAttribFormat, "glVertexArrayAttribFormat");
  fill(VertexArrayAttribBinding, "glVertexArrayAttribBinding");
  fill(CreateTextures, "glCreateTextures");
  fill(DeleteTextures, "glDeleteTextures");
  fill(TextureStorage2D, "glTextureStorage2D");
  fill(TextureStorage3D, "glTextureStorage3D");
  fill(TextureSubImage2D, "glTextureSubImage2D");
  fill(TextureParameteri, "glTextureParameteri");
  fill(BindTextureUnit, "glBindTextureUnit");
  fill(CopyImageSubData, "glCopyImageSubData");
  fill(CreateFramebuffers, "glCreateFramebuffers");
  fill(DeleteFramebuffers, "glDeleteFramebuffers");
  fill(BindFramebuffer, "glBindFramebuffer");
  fill(NamedFramebufferTexture, "glNamedFramebufferTexture");
  fill(NamedFramebufferTextureLayer, "glNamedFramebufferTextureLayer");
  fill(NamedFramebufferDrawBuffers, "glNamedFramebufferDrawBuffers");
  fill(NamedFramebufferReadBuffer, "glNamedFramebufferReadBuffer");
  fill(CheckNamedFramebufferStatus, "glCheckNamedFramebufferStatus");
  fill(ClearNamedFramebufferfv, "glClearNamedFramebufferfv");
  fill(ClearNamedFramebufferfi, "glClearNamedFramebufferfi");
  fill(ClearNamedFramebufferuiv, "glClearNamedFramebufferuiv");
  fill(CreateShader, "glCreateShader");
  fill(DeleteShader, "glDeleteShader");
  fill(ShaderSource, "glShaderSource");
  fill(CompileShader, "glCompileShader");
  fill(GetShaderiv, "glGetShaderiv");
  fill(GetShaderInfoLog, "glGetShaderInfoLog");
  fill(CreateProgram, "glCreateProgram");
  fill(DeleteProgram, "glDeleteProgram");
  fill(AttachShader, "glAttachShader");
  fill(LinkProgram, "glLinkProgram");
  fill(GetProgramiv, "glGetProgramiv");
  fill(GetProgramInfoLog, "glGetProgramInfoLog");
  fill(UseProgram, "glUseProgram");
  fill(GetUniformLocation, "glGetUniformLocation");
  fill(ProgramUniform1i, "glProgramUniform1i");
  fill(ProgramUniform1ui, "glProgramUniform1ui");
  fill(ProgramUniform1f, "glProgramUniform1f");
  fill(ProgramUniform3fv, "glProgramUniform3fv");
  fill(ProgramUniform4fv, "glProgramUniform4fv");
  fill(ProgramUniformMatrix4fv, "glProgramUniformMatrix4fv");
  if (!fill.missing().empty()) {
    throw Error("Mesa lacks OpenGL functions (" + fill.missing() + "); OpenGL 4.5 is needed");
  }
}

}  // namespace synthetic_dataset::render
