#include "randomize/appearance/variety/canvas_making.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/image/picture_channels.h"
#include "randomize/appearance/variety/texel_raster.h"
#include "randomize/appearance/variety/texture_atlas.h"
#include "randomize/appearance/variety/textured_triangle.h"

namespace synthetic_dataset::randomize {
namespace {

constexpr int kLargestSide = 1024;  // [px]

bool hasTexture(const world::Surface& surface) {
  return surface.material.texture && !surface.mesh->texture_coordinates.empty();
}

/// Halves a picture: each pixel is the mean of two by two.
cv::Mat halved(const cv::Mat& pixels) {
  cv::Mat result(std::max(pixels.rows / 2, 1), std::max(pixels.cols / 2, 1), CV_8UC4);
  for (int row = 0; row < result.rows; ++row) {
    for (int column = 0; column < result.cols; ++column) {
      const int r = std::min(2 * row + 1, pixels.rows - 1);
      const int c = std::min(2 * column + 1, pixels.cols - 1);
      const std::array<cv::Vec4b, 4> four = {
          pixels.at<cv::Vec4b>(2 * row, 2 * column), pixels.at<cv::Vec4b>(r, 2 * column),
          pixels.at<cv::Vec4b>(2 * row, c), pixels.at<cv::Vec4b>(r, c)};
      for (int i = 0; i < 4; ++i) {
        const int sum = four[0][i] + four[1][i] + four[2][i] + four[3][i];
        result.at<cv::Vec4b>(row, column)[i] = static_cast<std::uint8_t>((sum + 2) / 4);
      }
    }
  }
  return result;
}

std::shared_ptr<const world::Texture> textureOf(const std::string& file, cv::Mat pixels) {
  auto texture = std::make_shared<world::Texture>();
  texture->file = file;
  texture->pixels = std::move(pixels);
  return texture;
}

/// Sets the material's own colour to white, since the texture already includes it.
void whiten(world::Material& material) {
  for (int i = 0; i < 3; ++i) {
    constexpr float kDark = 0.02F;
    const float colour = material.diffuse[i];
    material.ambient[i] = colour > kDark ? std::min(material.ambient[i] / colour, 1.0F) : 1.0F;
    material.diffuse[i] = 1.0F;
  }
  material.is_default = false;
}

/// Surfaces that show the same texture in the same colour.
struct TextureGroup {
  std::shared_ptr<const world::Texture> texture;
  Eigen::Vector4f diffuse;
  std::vector<std::size_t> surfaces;  ///< indices in the parts' surfaces
};

std::vector<TextureGroup> groupsOf(const world::Model& model, const ModelParts& parts) {
  std::vector<TextureGroup> groups;
  for (std::size_t i = 0; i < parts.surfaces.size(); ++i) {
    const world::Surface& surface = surfaceOf(model, parts.surfaces[i]);
    if (!hasTexture(surface) || !isPaintable(surface)) continue;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const TextureGroup& group) {
      return group.texture == surface.material.texture && group.diffuse == surface.material.diffuse;
    });
    if (same != groups.end()) {
      same->surfaces.push_back(i);
    } else {
      groups.push_back({surface.material.texture, surface.material.diffuse, {i}});
    }
  }
  return groups;
}

/// Whether nearly every texel is shown at one place only, so that it can be painted by its place.
bool hasOwnTexels(const world::Model& model, const ModelParts& parts, const TextureGroup& group) {
  constexpr double kSamePlace = 0.03;   // of the model's size
  constexpr double kMostShared = 0.15;  // of the texels
  constexpr std::size_t kFewest = 400;
  constexpr double kMostRepeats = 16.0;
  const cv::Mat& pixels = group.texture->pixels;
  const auto same = static_cast<float>(kSamePlace * parts.box_M.sizes().maxCoeff());
  std::vector<std::optional<Eigen::Vector3f>> places(pixels.total());
  std::size_t seen = 0;
  std::size_t shared = 0;
  for (const std::size_t i : group.surfaces) {
    const SurfacePart& part = parts.surfaces[i];
    const world::Surface& surface = surfaceOf(model, part);
    if (!surface.mesh->colours.empty()) return false;
    const std::vector<std::uint32_t>& indices = surface.mesh->indices;
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
      const TexturedTriangle triangle(surface, part, k, pixels);
      const auto& corners = triangle.corners;
      const Eigen::Vector2d size =
          (corners[1] - corners[0]).cwiseAbs().cwiseMax((corners[2] - corners[0]).cwiseAbs());
      if (!(size.x() < kMostRepeats * pixels.cols && size.y() < kMostRepeats * pixels.rows)) {
        return false;
      }
      forEachTexel(corners, [&](int column, int row, const Eigen::Vector3d& weights) {
        auto& place = places[wrappedIndex(column, row, pixels)];
        const Eigen::Vector3f here = (triangle.p_M * weights).cast<float>();
        if (!place) {
          ++seen;
          place = here;
        } else if ((*place - here).norm() > same) {
          ++shared;
        }
      });
    }
  }
  return seen >= kFewest && static_cast<double>(shared) <= kMostShared * static_cast<double>(seen);
}

bool shinesInItsColours(const world::Material& material) {
  return material.emissive_map && material.texture &&
         material.emissive_map->file == material.texture->file;
}

/// Whether new texture coordinates are possible: other maps use the same coordinates, and holes are
/// cut by the texture itself.
bool canBeUnwrapped(const world::Surface& surface) {
  const world::Material& material = surface.material;
  return !material.normal_map && !material.roughness_map && !material.metalness_map &&
         (!material.emissive_map || shinesInItsColours(material)) &&
         (!material.texture || base::isOpaque(material.texture->pixels));
}

/// The side of a surface's new texture [px], by its share of the model; finer if it has a picture.
int sideFor(const world::Surface& surface, double share) {
  const double wanted = (hasTexture(surface) ? 1024.0 : 512.0) * std::sqrt(share);
  int side = 64;
  while (side < wanted && side < kLargestSide) side *= 2;
  return side;
}

/// Unwraps surfaces; identical ones share the result.
class Unwrapping {
 public:
  Unwrapping(world::Model& model, const ModelParts& parts) : model_(model), parts_(parts) {}

  void unwrap(std::size_t number) {
    const SurfacePart& part = parts_.surfaces[number];
    world::Surface& surface = surfaceOf(model_, part);
    const auto known = std::find_if(made_.begin(), made_.end(), [&](const Made& made) {
      return made.from.mesh == surface.mesh &&
             made.from.material.texture == surface.material.texture &&
             made.from.material.diffuse == surface.material.diffuse;
    });
    if (known == made_.end()) {
      const double share = areaOf(surface, part) / std::max(parts_.area, 1e-12);
      made_.push_back({surface, nullptr, nullptr});
      Made& made = made_.back();
      if (auto result = unwrapped(surface, sideFor(surface, share))) {
        made.mesh = result->mesh;
        const auto& texture = surface.material.texture;
        made.texture = textureOf(texture ? texture->file : "painted", result->picture);
      }
      take(made, surface);
    } else {
      take(*known, surface);
    }
  }

 private:
  struct Made {
    world::Surface from;
    std::shared_ptr<const world::Mesh> mesh;  ///< null if it could not be unwrapped
    std::shared_ptr<const world::Texture> texture;
  };

  static void take(const Made& made, world::Surface& surface) {
    if (!made.mesh) return;
    surface.mesh = made.mesh;
    world::Material& material = surface.material;
    setTexture(made.texture, material);
    material.texture_scale.setOnes();
    material.texture_offset.setZero();
    whiten(material);
  }

  world::Model& model_;
  const ModelParts& parts_;
  std::vector<Made> made_;
};

/// Bakes a material's colour into its texture, which is shrunk to a size that is quick to paint.
void bringColourIn(world::Model& model, const ModelParts& parts, const TextureGroup& group) {
  cv::Mat pixels = group.texture->pixels;
  while (std::max(pixels.rows, pixels.cols) > kLargestSide) pixels = halved(pixels);
  if (group.diffuse.head<3>() != Eigen::Vector3f::Ones()) {
    pixels = pixels.clone();
    for (int row = 0; row < pixels.rows; ++row) {
      for (int column = 0; column < pixels.cols; ++column) {
        auto& pixel = pixels.at<cv::Vec4b>(row, column);
        for (int i = 0; i < 3; ++i) {
          pixel[i] =
              cv::saturate_cast<std::uint8_t>(group.diffuse[2 - i] * static_cast<float>(pixel[i]));
        }
      }
    }
  }
  const auto texture = textureOf(group.texture->file, pixels);
  for (const std::size_t i : group.surfaces) {
    world::Material& material = surfaceOf(model, parts.surfaces[i]).material;
    setTexture(texture, material);
    whiten(material);
  }
}

}  // namespace

bool isPaintable(const world::Surface& surface) {
  const world::Material& material = surface.material;
  return material.diffuse[3] >= 1.0F && !material.texture_is_glass && !material.overlay;
}

void setTexture(const std::shared_ptr<const world::Texture>& texture, world::Material& material) {
  if (shinesInItsColours(material)) material.emissive_map = texture;
  material.texture = texture;
}

void makeCanvases(world::Model& model) {
  constexpr double kSmall = 0.03;  // of the model's surface: not worth a picture
  const ModelParts parts(model);
  Unwrapping unwrapping(model, parts);
  for (const TextureGroup& group : groupsOf(model, parts)) {
    const bool is_own = hasOwnTexels(model, parts, group);
    for (const std::size_t i : group.surfaces) {
      if (!is_own && canBeUnwrapped(surfaceOf(model, parts.surfaces[i]))) unwrapping.unwrap(i);
    }
    TextureGroup left{group.texture, group.diffuse, {}};
    for (const std::size_t i : group.surfaces) {
      const bool is_left = surfaceOf(model, parts.surfaces[i]).material.texture == group.texture;
      if (is_left) left.surfaces.push_back(i);
    }
    if (!left.surfaces.empty()) bringColourIn(model, parts, left);
  }
  for (std::size_t i = 0; i < parts.surfaces.size(); ++i) {
    const world::Surface& surface = surfaceOf(model, parts.surfaces[i]);
    if (hasTexture(surface) || !isPaintable(surface) || !canBeUnwrapped(surface)) continue;
    if (areaOf(surface, parts.surfaces[i]) > kSmall * parts.area) unwrapping.unwrap(i);
  }
}

}  // namespace synthetic_dataset::randomize
