#include "render/gl/shader_program.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

GlShader compile(const GlFunctions& gl, GLenum stage, const std::string& source) {
  GlShader shader(gl, gl.CreateShader(stage));
  const char* text = source.c_str();
  gl.ShaderSource(shader.name(), 1, &text, nullptr);
  gl.CompileShader(shader.name());
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_TRUE) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    throw Error("a shader does not compile: " + log.substr(0, static_cast<std::size_t>(length)));
  }
  return shader;
}

}  // namespace

ShaderProgram::ShaderProgram(const GlFunctions& gl, const std::string& vertex_source,
                             const std::string& fragment_source)
    : gl_(gl), program_(gl, gl.CreateProgram()) {
  const GlShader vertex = compile(gl, GL_VERTEX_SHADER, vertex_source);
  const GlShader fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source);
  gl.AttachShader(program_.name(), vertex.name());
  gl.AttachShader(program_.name(), fragment.name());
  gl.LinkProgram(program_.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    gl.GetProgramInfoLog(program_.name(), static_cast<GLsizei>(log.size()), &length, log.data());
    throw Error("shaders do not link: " + log.substr(0, static_cast<std::size_t>(length)));
  }
}

void ShaderProgram::use() const { gl_.UseProgram(program_.name()); }

GLint ShaderProgram::location(const std::string& uniform) const {
  const auto [entry, added] = locations_.try_emplace(uniform, -1);
  if (added) entry->second = gl_.GetUniformLocation(program_.name(), uniform.c_str());
  return entry->second;
}

void ShaderProgram::set(const std::string& uniform, int value) const {
  gl_.ProgramUniform1i(program_.name(), location(uniform), value);
}

void ShaderProgram::set(const std::string& uniform, std::uint32_t value) const {
  gl_.ProgramUniform1ui(program_.name(), location(uniform), value);
}

void ShaderProgram::set(const std::string& uniform, float value) const {
  gl_.ProgramUniform1f(program_.name(), location(uniform), value);
}

void ShaderProgram::set(const std::string& uniform, const Eigen::Vector3f& value) const {
  gl_.ProgramUniform3fv(program_.name(), location(uniform), 1, value.data());
}

void ShaderProgram::set(const std::string& uniform, const Eigen::Vector4f& value) const {
  gl_.ProgramUniform4fv(program_.name(), location(uniform), 1, value.data());
}

void ShaderProgram::set(const std::string& uniform,
                        const std::vector<Eigen::Vector4f>& values) const {
  gl_.ProgramUniform4fv(program_.name(), location(uniform), static_cast<GLsizei>(values.size()),
                        values.front().data());
}

void ShaderProgram::set(const std::string& uniform, const Eigen::Matrix4f& value) const {
  gl_.ProgramUniformMatrix4fv(program_.name(), location(uniform), 1, GL_FALSE, value.data());
}

}  // namespace synthetic_dataset::render
