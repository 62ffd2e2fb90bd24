#include "programs/preview/preview_world.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace synthetic_dataset::programs {
namespace {

using visualization_msgs::Marker;

constexpr std::size_t kMostTriangles = 300000;  // a message of 36 MB

/// A texture is replaced by its mean colour, since markers have no textures.
std_msgs::ColorRGBA colourOf(const world::Material& material) {
  Eigen::Vector4f colour = material.diffuse;
  if (material.texture) {
    const cv::Scalar mean = cv::mean(material.texture->pixels) / 255.0;
    colour.head<3>() =
        colour.head<3>().cwiseProduct(Eigen::Vector3d(mean[2], mean[1], mean[0]).cast<float>());
  }
  std_msgs::ColorRGBA result;
  result.r = colour.x();
  result.g = colour.y();
  result.b = colour.z();
  result.a = colour.w();
  return result;
}

std::size_t trianglesOf(const world::Link& link) {
  std::size_t count = 0;
  for (const world::Visual& visual : link.visuals) {
    for (const world::Surface& surface : visual.surfaces) count += surface.mesh->indices.size() / 3;
  }
  return count;
}

void appendVisual(const world::Visual& visual, const Pose& X_GL, Marker& marker) {
  const Pose X_GV = X_GL * visual.X_LV;
  for (const world::Surface& surface : visual.surfaces) {
    const std_msgs::ColorRGBA colour = colourOf(surface.material);
    for (const std::uint32_t index : surface.mesh->indices) {
      const Eigen::Vector3d p_G = X_GV * surface.mesh->positions[index].cast<double>();
      geometry_msgs::Point point;
      point.x = p_G.x();
      point.y = p_G.y();
      point.z = p_G.z();
      marker.points.push_back(point);
      marker.colors.push_back(colour);
    }
  }
}

/// The world's own links, those with few triangles first, as many as can be drawn.
std::vector<std::size_t> drawnLinks(const world::World& world) {
  std::vector<std::pair<std::size_t, std::size_t>> links;  // by triangles
  for (std::size_t i = 0; i < world.links().size(); ++i) {
    const world::LinkInstance& link = world.links()[i];
    const std::size_t triangles = trianglesOf(*link.link);
    const bool is_of_world = link.role == world::Role::kStatic || link.role == world::Role::kProp;
    if (is_of_world && triangles > 0) links.emplace_back(triangles, i);
  }
  std::sort(links.begin(), links.end());
  std::vector<std::size_t> drawn;
  std::size_t sum = 0;
  for (const auto& [triangles, index] : links) {
    sum += triangles;
    if (sum > kMostTriangles) break;
    drawn.push_back(index);
  }
  return drawn;
}

}  // namespace

visualization_msgs::MarkerArray worldMarkers(const world::World& world,
                                             const ros_messages::SceneFrames& frames, Stamp stamp) {
  visualization_msgs::MarkerArray markers;
  Marker clear;
  clear.header = ros_messages::headerOf(stamp, frames.globalFrame());
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  for (const std::size_t i : drawnLinks(world)) {
    Marker marker;
    marker.header = clear.header;
    marker.ns = "world";
    marker.id = static_cast<int>(i);
    marker.type = Marker::TRIANGLE_LIST;
    marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
    marker.color.a = 1.0F;
    marker.pose.orientation.w = 1.0;
    for (const world::Visual& visual : world.links()[i].link->visuals) {
      appendVisual(visual, world.linkPoses()[i], marker);
    }
    markers.markers.push_back(std::move(marker));
  }
  return markers;
}

}  // namespace synthetic_dataset::programs
