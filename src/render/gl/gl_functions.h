#pragma once

#include <GL/glcorearb.h>

namespace synthetic_dataset::render {

/// The OpenGL 4.5 entry points that the renderer uses.
///
/// They are obtained from the platform's own loader (OSMesa's or EGL's) and never linked: a libGL
/// that some other library pulled into the process would provide the same names, but knows nothing
/// of the offscreen context.
struct GlFunctions {
  /// @param load  returns an entry point by its name, or nullptr
  /// @throws Error naming the entry points that are missing
  explicit GlFunctions(void* (*load)(const char* name));

  PFNGLGETSTRINGPROC GetString = nullptr;
  PFNGLENABLEPROC Enable = nullptr;
  PFNGLDISABLEPROC Disable = nullptr;
  PFNGLVIEWPORTPROC Viewport = nullptr;
  PFNGLSCISSORPROC Scissor = nullptr;
  PFNGLDEPTHFUNCPROC DepthFunc = nullptr;
  PFNGLDEPTHMASKPROC DepthMask = nullptr;
  PFNGLFRONTFACEPROC FrontFace = nullptr;
  PFNGLSTENCILFUNCPROC StencilFunc = nullptr;
  PFNGLSTENCILOPPROC StencilOp = nullptr;
  PFNGLSTENCILMASKPROC StencilMask = nullptr;
  PFNGLBLENDFUNCSEPARATEPROC BlendFuncSeparate = nullptr;
  PFNGLCLIPCONTROLPROC ClipControl = nullptr;
  PFNGLPIXELSTOREIPROC PixelStorei = nullptr;
  PFNGLFLUSHPROC Flush = nullptr;
  PFNGLREADPIXELSPROC ReadPixels = nullptr;
  PFNGLDRAWARRAYSINSTANCEDPROC DrawArraysInstanced = nullptr;
  PFNGLDRAWELEMENTSPROC DrawElements = nullptr;

  PFNGLCREATEBUFFERSPROC CreateBuffers = nullptr;
  PFNGLDELETEBUFFERSPROC DeleteBuffers = nullptr;
  PFNGLNAMEDBUFFERSTORAGEPROC NamedBufferStorage = nullptr;
  PFNGLCREATEVERTEXARRAYSPROC CreateVertexArrays = nullptr;
  PFNGLDELETEVERTEXARRAYSPROC DeleteVertexArrays = nullptr;
  PFNGLBINDVERTEXARRAYPROC BindVertexArray = nullptr;
  PFNGLVERTEXARRAYVERTEXBUFFERPROC VertexArrayVertexBuffer = nullptr;
  PFNGLVERTEXARRAYELEMENTBUFFERPROC VertexArrayElementBuffer = nullptr;
  PFNGLENABLEVERTEXARRAYATTRIBPROC EnableVertexArrayAttrib = nullptr;
  PFNGLVERTEXARRAYATTRIBFORMATPROC VertexArrayAttribFormat = nullptr;
  PFNGLVERTEXARRAYATTRIBBINDINGPROC VertexArrayAttribBinding = nullptr;

  PFNGLCREATETEXTURESPROC CreateTextures = nullptr;
  PFNGLDELETETEXTURESPROC DeleteTextures = nullptr;
  PFNGLTEXTURESTORAGE2DPROC TextureStorage2D = nullptr;
  PFNGLTEXTURESTORAGE3DPROC TextureStorage3D = nullptr;
  PFNGLTEXTURESUBIMAGE2DPROC TextureSubImage2D = nullptr;
  PFNGLTEXTUREPARAMETERIPROC TextureParameteri = nullptr;
  PFNGLBINDTEXTUREUNITPROC BindTextureUnit = nullptr;
  PFNGLCOPYIMAGESUBDATAPROC CopyImageSubData = nullptr;

  PFNGLCREATEFRAMEBUFFERSPROC CreateFramebuffers = nullptr;
  PFNGLDELETEFRAMEBUFFERSPROC DeleteFramebuffers = nullptr;
  PFNGLBINDFRAMEBUFFERPROC BindFramebuffer = nullptr;
  PFNGLNAMEDFRAMEBUFFERTEXTUREPROC NamedFramebufferTexture = nullptr;
  PFNGLNAMEDFRAMEBUFFERTEXTURELAYERPROC NamedFramebufferTextureLayer = nullptr;
  PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC NamedFramebufferDrawBuffers = nullptr;
  PFNGLNAMEDFRAMEBUFFERREADBUFFERPROC NamedFramebufferReadBuffer = nullptr;
  PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC CheckNamedFramebufferStatus = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERFVPROC ClearNamedFramebufferfv = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERFIPROC ClearNamedFramebufferfi = nullptr;
  PFNGLCLEARNAMEDFRAMEBUFFERUIVPROC ClearNamedFramebufferuiv = nullptr;

  PFNGLCREATESHADERPROC CreateShader = nullptr;
  PFNGLDELETESHADERPROC DeleteShader = nullptr;
  PFNGLSHADERSOURCEPROC ShaderSource = nullptr;
  PFNGLCOMPILESHADERPROC CompileShader = nullptr;
  PFNGLGETSHADERIVPROC GetShaderiv = nullptr;
  PFNGLGETSHADERINFOLOGPROC GetShaderInfoLog = nullptr;
  PFNGLCREATEPROGRAMPROC CreateProgram = nullptr;
  PFNGLDELETEPROGRAMPROC DeleteProgram = nullptr;
  PFNGLATTACHSHADERPROC AttachShader = nullptr;
  PFNGLLINKPROGRAMPROC LinkProgram = nullptr;
  PFNGLGETPROGRAMIVPROC GetProgramiv = nullptr;
  PFNGLGETPROGRAMINFOLOGPROC GetProgramInfoLog = nullptr;
  PFNGLUSEPROGRAMPROC UseProgram = nullptr;
  PFNGLGETUNIFORMLOCATIONPROC GetUniformLocation = nullptr;
  PFNGLPROGRAMUNIFORM1IPROC ProgramUniform1i = nullptr;
  PFNGLPROGRAMUNIFORM1UIPROC ProgramUniform1ui = nullptr;
  PFNGLPROGRAMUNIFORM1FPROC ProgramUniform1f = nullptr;
  PFNGLPROGRAMUNIFORM3FVPROC ProgramUniform3fv = nullptr;
  PFNGLPROGRAMUNIFORM4FVPROC ProgramUniform4fv = nullptr;
  PFNGLPROGRAMUNIFORMMATRIX4FVPROC ProgramUniformMatrix4fv = nullptr;
};

}  // namespace synthetic_dataset::render
