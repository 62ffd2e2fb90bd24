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
  Eigen::Vector3f ambient{0.0F, 0.0F, 0.0F};  ///< to be multiplied by the scene's
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f diffuse{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f specular{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f glow{0.0F, 0.0F, 0.0F};  ///< to be multiplied by its picture
  float shininess = 0.0F;
};

[[nodiscard]] ClassicLight classicLight(const world::Material& material);

/// Lighting properties that are constant over an item.
struct ItemLight {
  Eigen::Vector3f emissive{0.0F, 0.0F, 0.0F};  ///< linear
  float reflectance = 0.0F;                    ///< below 0 if the item is unlit
  ClassicLight classic;                        ///< in its worlds, instead of the others
};

/// Whether a material has an emissive picture other than its diffuse one, by which Gazebo Classic
/// multiplies all light except highlights.
[[nodiscard]] bool hasGlowOfItsOwn(const world::Material& material);

/// An item's material, for lighting without OpenGL; it does not change when the item gets another
/// material.
struct ItemSurface {
  const world::Mesh* shape = nullptr;
  Eigen::Vector4f diffuse{1.0F, 1.0F, 1.0F, 1.0F};  ///< as in the shaders
  Eigen::Vector2f scale{1.0F, 1.0F};                ///< of texture coordinates
  Eigen::Vector2f offset{0.0F, 0.0F};
  float roughness = 0.0F;
  float metalness = 0.0F;
  float alpha_threshold = 0.0F;
  std::vector<Eigen::Vector4f> const* tints = nullptr;  ///< of the vertices; null for none
  bool tints_are_encoded = false;

  // Null if there is none.
  std::shared_ptr<const PicturePyramid> colours;
  std::shared_ptr<const PicturePyramid> normals;
  std::shared_ptr<const PicturePyramid> roughnesses;
  std::shared_ptr<const PicturePyramid> metalnesses;
  std::shared_ptr<const PicturePyramid> glows;
};

/// The surfaces of all items, indexed by their numbers in GeometryImages.
[[nodiscard]] std::vector<ItemSurface> itemSurfaces(const DrawList& draw_list,
                                                    PyramidLibrary& pyramids);

}  // namespace synthetic_dataset::render
