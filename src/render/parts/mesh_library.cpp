#include "render/parts/mesh_library.h"

#include <cstddef>
#include <vector>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// A vertex as the shaders read it; the numbers below are the attributes' locations there.
struct Vertex {
  float position[3];
  float normal[3];
  float texture_coordinates[2];
};

constexpr GLuint kPosition = 0;
constexpr GLuint kNormal = 1;
constexpr GLuint kTextureCoordinates = 2;
constexpr GLuint kColour = 3;

std::vector<Vertex> interleave(const world::Mesh& mesh) {
  std::vector<Vertex> vertices(mesh.positions.size());
  const bool textured = mesh.texture_coordinates.size() == mesh.positions.size();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3f& position = mesh.positions[i];
    const Eigen::Vector3f& normal = mesh.normals[i];
    const Eigen::Vector2f coordinates =
        textured ? mesh.texture_coordinates[i] : Eigen::Vector2f(0.0F, 0.0F);
    vertices[i] = {{position.x(), position.y(), position.z()},
                   {normal.x(), normal.y(), normal.z()},
                   {coordinates.x(), coordinates.y()}};
  }
  return vertices;
}

}  // namespace

bool hasColours(const world::Mesh& mesh) {
  return !mesh.colours.empty() && mesh.colours.size() == mesh.positions.size();
}

MeshBuffers::MeshBuffers(const GlFunctions& gl, const world::Mesh& mesh, PixelMeaning colours)
    : gl_(gl),
      vertices_(makeBuffer(gl)),
      indices_(makeBuffer(gl)),
      layout_(makeVertexArray(gl)),
      index_count_(static_cast<GLsizei>(mesh.indices.size())) {
  if (mesh.indices.empty()) return;  // OpenGL refuses empty buffers; draw() skips the mesh
  const std::vector<Vertex> vertices = interleave(mesh);
  gl.NamedBufferStorage(vertices_.name(), static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                        vertices.data(), 0);
  gl.NamedBufferStorage(indices_.name(),
                        static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(std::uint32_t)),
                        mesh.indices.data(), 0);
  gl.VertexArrayVertexBuffer(layout_.name(), 0, vertices_.name(), 0, sizeof(Vertex));
  gl.VertexArrayElementBuffer(layout_.name(), indices_.name());
  const auto attribute = [&](GLuint location, GLint size, std::size_t offset) {
    gl.EnableVertexArrayAttrib(layout_.name(), location);
    gl.VertexArrayAttribFormat(layout_.name(), location, size, GL_FLOAT, GL_FALSE,
                               static_cast<GLuint>(offset));
    gl.VertexArrayAttribBinding(layout_.name(), location, 0);
  };
  attribute(kPosition, 3, offsetof(Vertex, position));
  attribute(kNormal, 3, offsetof(Vertex, normal));
  attribute(kTextureCoordinates, 2, offsetof(Vertex, texture_coordinates));
  if (hasColours(mesh)) addColours(mesh, colours);
}

/// Colours have a separate buffer, as most meshes have none.
void MeshBuffers::addColours(const world::Mesh& mesh, PixelMeaning meaning) {
  constexpr GLuint kBinding = 1;
  std::vector<Eigen::Vector4f> colours;
  for (const Eigen::Vector4f& colour : mesh.colours) {
    colours.push_back(meaning == PixelMeaning::kColour ? linearFromSrgb(colour) : colour);
  }
  colours_ = makeBuffer(gl_);
  gl_.NamedBufferStorage(colours_.name(),
                         static_cast<GLsizeiptr>(colours.size() * sizeof(Eigen::Vector4f)),
                         colours.data(), 0);
  gl_.VertexArrayVertexBuffer(layout_.name(), kBinding, colours_.name(), 0,
                              sizeof(Eigen::Vector4f));
  gl_.EnableVertexArrayAttrib(layout_.name(), kColour);
  gl_.VertexArrayAttribFormat(layout_.name(), kColour, 4, GL_FLOAT, GL_FALSE, 0);
  gl_.VertexArrayAttribBinding(layout_.name(), kColour, kBinding);
}

void MeshBuffers::draw() const {
  if (index_count_ == 0) return;
  gl_.BindVertexArray(layout_.name());
  gl_.DrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

const MeshBuffers& MeshLibrary::get(const std::shared_ptr<const world::Mesh>& mesh) {
  return buffers_.try_emplace(mesh, gl_, *mesh, colours_).first->second;
}

}  // namespace synthetic_dataset::render
