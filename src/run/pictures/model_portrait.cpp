#include "run/pictures/model_portrait.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "render/renderer.h"
#include "world/material/default_paint.h"

namespace synthetic_dataset::run {
namespace {

/// All textures that a material may have; null if absent.
std::vector<const world::Texture*> texturesOf(const world::Material& material) {
  return {material.texture.get(), material.normal_map.get(), material.roughness_map.get(),
          material.metalness_map.get(), material.emissive_map.get()};
}

/// A grey square under the model, slightly lower so that it does not intersect the model's own.
world::Link groundUnder(const Eigen::AlignedBox3d& bounds) {
  constexpr double kGap = 0.002;   // of the model's size
  constexpr double kWidth = 60.0;  // of the model's size: to the horizon
  const double size = bounds.diagonal().norm();
  const auto half = static_cast<float>(0.5 * kWidth * size);
  auto mesh = std::make_shared<world::Mesh>();
  for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
    mesh->positions.emplace_back(x * half, y * half, 0.0F);
    mesh->normals.emplace_back(0.0F, 0.0F, 1.0F);
  }
  mesh->indices = {0, 1, 2, 0, 2, 3};
  world::Visual visual;
  visual.casts_shadow = false;
  visual.X_LV.translation() = bounds.center();
  visual.X_LV.translation().z() = bounds.min().z() - kGap * size;
  world::Material material;
  material.diffuse = {0.78F, 0.78F, 0.77F, 1.0F};
  material.specular.setZero();
  visual.surfaces.push_back({mesh, material});
  world::Link link;
  link.visuals.push_back(visual);
  return link;
}

/// A light background, and a sun behind the camera's left shoulder.
world::Description studio() {
  world::Description studio;
  studio.simulator = world::Simulator::kGz;  // the same light for all models
  studio.ambient = {0.62F, 0.62F, 0.64F};
  studio.background = {0.86F, 0.89F, 0.92F};
  world::Light sun;
  sun.casts_shadow = true;
  sun.direction_L = Eigen::Vector3d(-0.55, -0.35, -0.9).normalized();
  sun.diffuse = {0.75F, 0.74F, 0.72F};
  studio.lights.push_back(sun);
  return studio;
}

}  // namespace

ModelCounts countModels(const world::Description& description) {
  ModelCounts counts;
  std::set<const world::Texture*> textures;
  for (const world::Model& model : description.models) {
    counts.links += model.links.size();
    for (const world::Link& link : model.links) {
      counts.visuals += link.visuals.size();
      for (const world::Visual& visual : link.visuals) {
        counts.surfaces += visual.surfaces.size();
        for (const world::Surface& surface : visual.surfaces) {
          counts.triangles += surface.mesh->indices.size() / 3;
          for (const auto* texture : texturesOf(surface.material)) textures.insert(texture);
        }
      }
    }
  }
  textures.erase(nullptr);
  counts.textures = textures.size();
  return counts;
}

Eigen::AlignedBox3d visibleBounds(const world::Model& model, const Pose& X_AM) {
  Eigen::AlignedBox3d bounds;
  for (const world::Link& link : model.links) {
    for (const world::Visual& visual : link.visuals) {
      const Pose X_AV = X_AM * link.X_ML * visual.X_LV;
      for (const world::Surface& surface : visual.surfaces) {
        for (const Eigen::Vector3f& p : surface.mesh->positions) {
          bounds.extend(X_AV * Eigen::Vector3d(p.cast<double>()));
        }
      }
    }
  }
  return bounds;
}

Eigen::AlignedBox3d visibleBounds(const world::Description& description) {
  Eigen::AlignedBox3d bounds;
  for (const world::Model& model : description.models) {
    bounds.extend(visibleBounds(model, model.X_WM));
  }
  return bounds;
}

Eigen::Vector3d directionFrom(double longitude, double latitude) {
  constexpr double kSteepest = 1.55;  // [rad]
  const double up = std::clamp(latitude, -kSteepest, kSteepest);
  return -Eigen::Vector3d(std::cos(up) * std::cos(longitude), std::cos(up) * std::sin(longitude),
                          std::sin(up));
}

render::View portraitView(const Eigen::AlignedBox3d& bounds_W, const cv::Size& size,
                          const Eigen::Vector3d& ahead_W) {
  constexpr double kFocalLength = 1.6;  // of the picture's width: a slight telephoto lens
  constexpr double kFilled = 0.88;      // share of the picture filled by the box
  Eigen::Matrix3d R_WC;
  R_WC.col(2) = ahead_W.normalized();
  R_WC.col(0) = R_WC.col(2).cross(Eigen::Vector3d::UnitZ()).normalized();
  R_WC.col(1) = R_WC.col(2).cross(R_WC.col(0));
  const double focal = kFocalLength * size.width;
  const double half_width = 0.5 * kFilled * size.width / focal;
  const double half_height = 0.5 * kFilled * size.height / focal;
  const Eigen::Vector3d centre = bounds_W.center();
  const double extent = std::max(bounds_W.diagonal().norm(), 1e-6);
  // The smallest distance at which every corner is within the picture.
  double distance = extent;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner = bounds_W.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    const Eigen::Vector3d p = R_WC.transpose() * (corner - centre);
    distance = std::max(
        {distance, std::abs(p.x()) / half_width - p.z(), std::abs(p.y()) / half_height - p.z()});
  }
  const CameraModel camera(size.width, size.height,
                           {focal, focal, 0.5 * (size.width - 1), 0.5 * (size.height - 1)},
                           0.05 * extent, 100.0 * extent);
  return {camera, makePose(centre - distance * R_WC.col(2), Eigen::Quaterniond(R_WC))};
}

cv::Mat portray(const world::Description& description, const cv::Size& size,
                const Eigen::Vector3d& ahead_W) {
  const Eigen::AlignedBox3d bounds = visibleBounds(description);
  if (bounds.isEmpty()) return {};
  const world::Link ground = groundUnder(bounds);
  std::vector<world::LinkInstance> links = {{&ground, world::Role::kStatic, -1}};
  std::vector<Pose> X_WL = {Pose::Identity()};
  std::vector<world::Model> models = description.models;
  for (world::Model& model : models) {
    world::paintDefaults(studio().simulator, model);
    for (const world::Link& link : model.links) {
      links.push_back({&link, world::Role::kStatic, -1});
      X_WL.push_back(model.X_WM * link.X_ML);
    }
  }
  const render::View view = portraitView(bounds, size, ahead_W);
  render::RenderOptions options;
  options.shadow_distance = 2.0 * (view.X_WC.translation() - bounds.center()).norm();
  render::Renderer renderer(studio(), links, options);
  const render::LinkSelection all(links.size(), true);
  return renderer.colour(view, X_WL, {all, all});
}

}  // namespace synthetic_dataset::run
