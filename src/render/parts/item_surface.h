#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "render/parts/draw_list.h"
#include "render/parts/picture_pyramid.h"
#include "world/description.h"

namespace synthetic_dataset::render {

/// The members of ClassicLanes that are constant over a surface.
struct ClassicLight {
  Eigen::Vector3f ambient{0.0F, 0.0F, 0.0F};  ///< times the scene's
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f diffuse{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f specular{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f glow{0.0F, 0.0F, 0.0F};  ///< times its picture's colour
  float shininess = 0.0F;
};

[[nodiscard]] ClassicLight classicLight(const world::Material& material);

/// Lighting properties that are constant over an item.
struct ItemLight {
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};  ///< linear
  float reflectance = 0.0F;                    ///< below 0 where light leaves it as it is
  ClassicLight classic;                        ///< in the others' place in its worlds
};

/// Whether a material's emissive picture is another than its own, by which Gazebo Classic
/// multiplies all light but highlights.
[[nodiscard]] bool hasGlowOfItsOwn(const world::Material& material);

/// What a part is made of, for what is found without OpenGL; it stays as it is when the part gets
/// another material.
struct ItemSurface {
  const world::Mesh* shape = nullptr;
  Eigen::Vector4f diffuse{1.0F, 1.0F, 1.0F, 1.0F};  ///< as shaders have it
  Eigen::Vector2f scale{1.0F, 1.0F};                ///< of texture coordinates
  Eigen::Vector2f offset{0.0F, 0.0F};
  float roughness = 0.0F;
  float metalness = 0.0F;
  float alpha_threshold = 0.0F;
  std::vector<Eigen::Vector4f> const* tints = nullptr;  ///< of the vertices; null for none
  bool tints_are_encoded = false;

  // Null where there is none.
  std::shared_ptr<const PicturePyramid> colours;
  std::shared_ptr<const PicturePyramid> normals;
  std::shared_ptr<const PicturePyramid> roughnesses;
  std::shared_ptr<const PicturePyramid> metalnesses;
  std::shared_ptr<const PicturePyramid> glows;
};

/// By the number that items have in GeometryImages.
[[nodiscard]] std::vector<ItemSurface> itemSurfaces(const DrawList& draw_list,
                                                    PyramidLibrary& pyramids);

}  // namespace synthetic_dataset::render
