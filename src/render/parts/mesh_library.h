#pragma once

#include <memory>
#include <unordered_map>

#include "render/gl/gl_object.h"
#include "render/pixels/light_picture.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// Whether each vertex has a colour.
[[nodiscard]] bool hasColours(const world::Mesh& mesh);

/// A mesh in OpenGL's buffers.
class MeshBuffers {
 public:
  /// @param colours  whether vertices' colours are made linear, or are kept as data
  MeshBuffers(const GlFunctions& gl, const world::Mesh& mesh, PixelMeaning colours);

  void draw() const;

 private:
  void addColours(const world::Mesh& mesh, PixelMeaning meaning);

  const GlFunctions& gl_;
  GlBuffer vertices_;
  GlBuffer colours_;  // empty for meshes without colours
  GlBuffer indices_;
  GlVertexArray layout_;
  GLsizei index_count_ = 0;
};

/// Uploads each mesh once, however many visuals share it.
class MeshLibrary {
 public:
  explicit MeshLibrary(const GlFunctions& gl, PixelMeaning colours = PixelMeaning::kColour)
      : gl_(gl), colours_(colours) {}

  /// The reference is valid as long as the library exists.
  [[nodiscard]] const MeshBuffers& get(const std::shared_ptr<const world::Mesh>& mesh);

 private:
  const GlFunctions& gl_;
  PixelMeaning colours_;
  std::unordered_map<std::shared_ptr<const world::Mesh>, MeshBuffers> buffers_;
};

}  // namespace synthetic_dataset::render
