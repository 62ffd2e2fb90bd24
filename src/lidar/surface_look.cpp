#include "lidar/surface_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::lidar {
namespace {

/// Interpolates a vertex attribute of a mesh at a place on a triangle.
template <class Vector>
Vector between(const std::vector<Vector>& of_corners, const world::Mesh& mesh,
               const SurfacePlace& place) {
  const std::uint32_t* corners = &mesh.indices[3 * place.triangle];
  const auto b1 = static_cast<float>(place.b1);
  const auto b2 = static_cast<float>(place.b2);
  return (1.0F - b1 - b2) * of_corners[corners[0]] + b1 * of_corners[corners[1]] +
         b2 * of_corners[corners[2]];
}

int repeated(int texel, int count) { return (texel % count + count) % count; }

/// Red, green, blue and alpha of a texture, 0 .. 1 as stored in its file, interpolated between the
/// centres of its texels; the texture repeats.
Eigen::Vector4f texelAt(const cv::Mat& pixels, const Eigen::Vector2f& coordinates) {
  const Eigen::Vector2f at(coordinates.x() * static_cast<float>(pixels.cols) - 0.5F,
                           coordinates.y() * static_cast<float>(pixels.rows) - 0.5F);
  constexpr float kFar = 1e9F;
  if (!(at.cwiseAbs().maxCoeff() < kFar)) return Eigen::Vector4f::Ones();
  const int left = static_cast<int>(std::floor(at.x()));
  const int top = static_cast<int>(std::floor(at.y()));
  Eigen::Vector4f sum = Eigen::Vector4f::Zero();
  for (int down = 0; down < 2; ++down) {
    const float share_down = 1.0F - std::abs(at.y() - static_cast<float>(top + down));
    const auto* row = pixels.ptr<cv::Vec4b>(repeated(top + down, pixels.rows));
    for (int right = 0; right < 2; ++right) {
      const float share = share_down * (1.0F - std::abs(at.x() - static_cast<float>(left + right)));
      const cv::Vec4b& bgra = row[repeated(left + right, pixels.cols)];
      sum += share / 255.0F * Eigen::Vector4f(bgra[2], bgra[1], bgra[0], bgra[3]);
    }
  }
  return sum;
}

bool canLookUp(const world::Mesh& mesh, const std::shared_ptr<const world::Texture>& texture) {
  return texture && texture->pixels.type() == CV_8UC4 && !mesh.texture_coordinates.empty();
}

Eigen::Vector4f textureAt(const world::Mesh& mesh, const world::Material& material,
                          const std::shared_ptr<const world::Texture>& texture,
                          const SurfacePlace& place) {
  if (!canLookUp(mesh, texture)) return Eigen::Vector4f::Ones();
  const Eigen::Vector2f coordinates = between(mesh.texture_coordinates, mesh, place);
  return texelAt(texture->pixels,
                 coordinates.cwiseProduct(material.texture_scale) + material.texture_offset);
}

/// Linear red, green and blue, and alpha.
Eigen::Vector4f colourAt(const world::Mesh& mesh, const world::Material& material,
                         const SurfacePlace& place) {
  Eigen::Vector4f colour = render::linearFromSrgb(material.diffuse);
  if (canLookUp(mesh, material.texture)) {
    const Eigen::Vector4f texel = textureAt(mesh, material, material.texture, place);
    colour = colour.cwiseProduct(render::linearFromSrgb(texel));
  }
  if (!mesh.colours.empty()) {
    const Eigen::Vector4f own = between(mesh.colours, mesh, place);
    colour = colour.cwiseProduct(render::linearFromSrgb(own));
  }
  if (!material.overlay) return colour;
  const Eigen::Vector4f over = colourAt(mesh, *material.overlay, place);
  const float alpha = std::clamp(over.w(), 0.0F, 1.0F);
  colour.head<3>() = alpha * over.head<3>() + (1.0F - alpha) * colour.head<3>();
  return colour;
}

/// Perceived brightness (Rec. 709).
double brightnessOf(const Eigen::Vector4f& colour) {
  return std::clamp(0.2126 * colour.x() + 0.7152 * colour.y() + 0.0722 * colour.z(), 0.0, 1.0);
}

double roughnessAt(const world::Mesh& mesh, const world::Material& material,
                   const SurfacePlace& place, world::Simulator simulator) {
  if (simulator == world::Simulator::kClassic) {
    // The roughness whose highlight is as wide as that of the exponent (Walter et al. 2007, section
    // 5.2); without a highlight: matt.
    if (material.shininess <= 0.0F || material.specular.isZero()) return 1.0;
    return std::pow(2.0 / (material.shininess + 2.0), 0.25);
  }
  const double map = textureAt(mesh, material, material.roughness_map, place).y();
  return material.roughness * map;
}

}  // namespace

bool isHole(const world::Mesh& mesh, const world::Material& material, const SurfacePlace& place) {
  return textureAt(mesh, material, material.texture, place).w() < material.alpha_threshold;
}

bool hasHoles(const world::Material& material) {
  if (!material.texture || material.texture_is_glass || material.alpha_threshold <= 0.0F) {
    return false;
  }
  const cv::Mat& pixels = material.texture->pixels;
  if (pixels.type() != CV_8UC4) return false;
  for (int row = 0; row < pixels.rows; ++row) {
    const auto* texels = pixels.ptr<cv::Vec4b>(row);
    if (std::any_of(texels, texels + pixels.cols, [](const cv::Vec4b& t) { return t[3] < 255; })) {
      return true;
    }
  }
  return false;
}

bool isTransparent(const world::Mesh& mesh, const world::Material& material) {
  if (material.diffuse.w() < 1.0F) return true;
  world::Material as_holes = material;
  as_holes.texture_is_glass = false;
  as_holes.alpha_threshold = 1.0F;
  if (material.texture_is_glass && hasHoles(as_holes)) return true;
  return std::any_of(mesh.colours.begin(), mesh.colours.end(),
                     [](const Eigen::Vector4f& colour) { return colour.w() < 1.0F; });
}

Eigen::Vector3d normalAt(const world::Mesh& mesh, const SurfacePlace& place,
                         const Eigen::Vector3d& direction) {
  const std::uint32_t* corners = &mesh.indices[3 * place.triangle];
  const Eigen::Vector3d a = mesh.positions[corners[0]].cast<double>();
  Eigen::Vector3d flat = (mesh.positions[corners[1]].cast<double>() - a)
                             .cross(mesh.positions[corners[2]].cast<double>() - a);
  if (flat.dot(direction) > 0.0) flat = -flat;
  Eigen::Vector3d smooth = between(mesh.normals, mesh, place).cast<double>();
  if (!(smooth.norm() > 0.0)) return flat.normalized();
  smooth.normalize();
  if (smooth.dot(flat) < 0.0) smooth = -smooth;
  // Near the silhouette of a round object it may point slightly away from the ray's origin.
  const double away = std::max(smooth.dot(direction), 0.0);
  smooth = (smooth - away * direction).normalized();
  return smooth.allFinite() ? smooth : flat.normalized();
}

double intensityAt(const world::Mesh& mesh, const world::Material& material,
                   const SurfacePlace& place, world::Simulator simulator, double cosine) {
  const double matt = brightnessOf(colourAt(mesh, material, place)) * cosine;
  constexpr double kReflectance = 0.04;  // of plastics and glass, at normal incidence
  const double roughness = std::max(roughnessAt(mesh, material, place, simulator), 0.05);
  if (roughness >= 1.0 || cosine <= 0.0) return std::clamp(matt, 0.0, 1.0);
  const double alpha = roughness * roughness;
  const double tangent_squared = (1.0 - cosine * cosine) / (cosine * cosine);
  const double lobe =
      std::exp(-tangent_squared / (alpha * alpha)) / (4.0 * alpha * alpha * std::pow(cosine, 4.0));
  return std::clamp(matt + kReflectance * lobe * cosine, 0.0, 1.0);
}

}  // namespace synthetic_dataset::lidar
