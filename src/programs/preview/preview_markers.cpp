#include "programs/preview/preview_markers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "run/check/moments.h"

namespace synthetic_dataset::programs {
namespace {

using visualization_msgs::Marker;

constexpr double kPointSize = 0.03;  // [m]
constexpr double kLineWidth = 0.01;  // [m]
constexpr double kViewDepth = 1.0;   // [m]
constexpr int kPiecesOfASide = 8;    // of the image, since lenses bend it

geometry_msgs::Point pointOf(const Eigen::Vector3d& p_G) {
  geometry_msgs::Point point;
  point.x = p_G.x();
  point.y = p_G.y();
  point.z = p_G.z();
  return point;
}

std_msgs::ColorRGBA colourOf(float red, float green, float blue) {
  std_msgs::ColorRGBA colour;
  colour.r = red;
  colour.g = green;
  colour.b = blue;
  colour.a = 1.0F;
  return colour;
}

const std_msgs::ColorRGBA kSeen = colourOf(0.1F, 0.9F, 0.2F);
const std_msgs::ColorRGBA kHidden = colourOf(0.9F, 0.2F, 0.1F);
const std_msgs::ColorRGBA kShape = colourOf(0.2F, 0.6F, 1.0F);
const std_msgs::ColorRGBA kView = colourOf(1.0F, 0.8F, 0.1F);

Marker markerOf(const std_msgs::Header& header, const std::string& name, int id, int type,
                double size) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.id = id;
  marker.type = type;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color = kView;
  return marker;
}

Marker keypointMarker(const std_msgs::Header& header, const SceneObject& object) {
  Marker marker =
      markerOf(header, "keypoints", object.instance, Marker::SPHERE_LIST, 2.0 * kPointSize);
  for (std::size_t i = 0; i < object.keypoints_O.size(); ++i) {
    marker.points.push_back(pointOf(*object.X_GO * object.keypoints_O[i]));
    const bool is_seen = object.keypoints[i].state() == KeypointState::kVisible;
    marker.colors.push_back(is_seen ? kSeen : kHidden);
  }
  return marker;
}

Marker shapeMarker(const std_msgs::Header& header, const SceneObject& object) {
  Marker marker =
      markerOf(header, "bounding shapes", object.instance, Marker::SPHERE_LIST, kPointSize);
  marker.color = kShape;
  for (const Eigen::Vector3d& p_O : object.bounding_shape_O) {
    marker.points.push_back(pointOf(*object.X_GO * p_O));
  }
  return marker;
}

/// Points around the image's edge; a lens may see only some of them.
std::vector<Eigen::Vector2d> edgeOf(const CameraModel& camera) {
  const Box image = camera.imageBounds();
  const std::array<Eigen::Vector2d, 5> corners = {
      Eigen::Vector2d(image.left, image.top), Eigen::Vector2d(image.right, image.top),
      Eigen::Vector2d(image.right, image.bottom), Eigen::Vector2d(image.left, image.bottom),
      Eigen::Vector2d(image.left, image.top)};
  std::vector<Eigen::Vector2d> points;
  for (std::size_t side = 0; side < 4; ++side) {
    for (int i = 0; i < kPiecesOfASide; ++i) {
      const double share = static_cast<double>(i) / kPiecesOfASide;
      points.emplace_back((1.0 - share) * corners.at(side) + share * corners.at(side + 1));
    }
  }
  points.push_back(corners.front());
  return points;
}

/// The colour of each instance number, beginning with 0, the world's.
std::vector<std_msgs::ColorRGBA> coloursOf(const std::vector<SceneObject>& objects) {
  std::vector<std_msgs::ColorRGBA> colours(1, colourOf(0.6F, 0.6F, 0.6F));
  for (const SceneObject& object : objects) {
    const std::size_t instance = object.instance;
    if (colours.size() <= instance) colours.resize(instance + 1, colours.front());
    colours[instance] = ros_messages::classColour(object.class_id, 1.0F);
  }
  return colours;
}

std_msgs::ColorRGBA colourOfWorld(const CloudPoint& point) {
  constexpr float kDarker = 0.6F;
  std_msgs::ColorRGBA colour = ros_messages::classColour(point.world_class, 1.0F);
  colour.r *= kDarker;
  colour.g *= kDarker;
  colour.b *= kDarker;
  return colour;
}

Marker cloudMarker(const std_msgs::Header& header, const Cloud& cloud,
                   const std::vector<std_msgs::ColorRGBA>& colours) {
  Marker marker =
      markerOf(header, "cloud", static_cast<int>(cloud.lidar), Marker::POINTS, kPointSize);
  for (const CloudPoint& point : cloud.points) {
    marker.points.push_back(
        pointOf(cloud.X_GS * Eigen::Vector3d(point.position_at_stamp_S.cast<double>())));
    const bool is_of_world = point.instance == 0 && point.world_class > 0;
    marker.colors.push_back(is_of_world
                                ? colourOfWorld(point)
                                : colours.at(point.instance < colours.size() ? point.instance : 0));
  }
  return marker;
}

}  // namespace

visualization_msgs::MarkerArray labelMarkers(const Scene& scene,
                                             const ros_messages::SceneFrames& frames) {
  const std_msgs::Header header = ros_messages::headerOf(scene.stamp, frames.globalFrame());
  visualization_msgs::MarkerArray markers = ros_messages::objectMarkers(scene, frames);
  for (const SceneObject& object : scene.objects) {
    if (!object.labelled()) continue;
    if (!object.keypoints_O.empty()) markers.markers.push_back(keypointMarker(header, object));
    if (!object.bounding_shape_O.empty()) markers.markers.push_back(shapeMarker(header, object));
  }
  return markers;
}

Marker viewMarker(const Scene& scene, const ros_messages::SceneFrames& frames) {
  Marker marker = markerOf(ros_messages::headerOf(scene.stamp, frames.globalFrame()), "view",
                           static_cast<int>(scene.camera_index), Marker::LINE_LIST, kLineWidth);
  const auto addLine = [&](const Eigen::Vector3d& from_C, const Eigen::Vector3d& to_C) {
    marker.points.push_back(pointOf(scene.X_GC * from_C));
    marker.points.push_back(pointOf(scene.X_GC * to_C));
  };
  Eigen::Vector3d last_C = Eigen::Vector3d::Zero();
  bool has_last = false;
  std::size_t index = 0;
  for (const Eigen::Vector2d& pixel : edgeOf(scene.camera)) {
    const bool is_corner = index++ % kPiecesOfASide == 0;
    const auto ray_C = scene.camera.ray(pixel);
    if (ray_C) {
      const Eigen::Vector3d end_C = kViewDepth * *ray_C;
      if (has_last) addLine(last_C, end_C);
      if (is_corner) addLine(Eigen::Vector3d::Zero(), end_C);
      last_C = end_C;
    }
    has_last = ray_C.has_value();
  }
  return marker;
}

visualization_msgs::MarkerArray cloudMarkers(const Scene& scene,
                                             const ros_messages::SceneFrames& frames) {
  const std_msgs::Header header = ros_messages::headerOf(scene.stamp, frames.globalFrame());
  const std::vector<std_msgs::ColorRGBA> colours = coloursOf(scene.objects);
  visualization_msgs::MarkerArray markers;
  for (const auto& cloud : scene.clouds()) {
    markers.markers.push_back(cloudMarker(header, *cloud, colours));
  }
  return markers;
}

visualization_msgs::MarkerArray wayMarkers(const run::MotionSetup& motion,
                                           const ros_messages::SceneFrames& frames, Stamp stamp) {
  const std_msgs::Header header = ros_messages::headerOf(stamp, frames.globalFrame());
  visualization_msgs::MarkerArray markers;
  Marker clear = markerOf(header, "", 0, Marker::CUBE, 1.0);
  clear.action = Marker::DELETEALL;
  markers.markers.push_back(clear);
  if (!motion.timeline.is_recorded) return markers;
  const std::vector<run::Moment> moments = run::momentsOf(motion, {});
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    Marker way =
        markerOf(header, "ways", static_cast<int>(i), Marker::LINE_STRIP, 2.0 * kLineWidth);
    way.color = kShape;
    for (const run::Moment& moment : moments) {
      if (moment.X_GO[i]) way.points.push_back(pointOf(moment.X_GO[i]->translation()));
    }
    if (way.points.size() > 1) markers.markers.push_back(way);
  }
  return markers;
}

}  // namespace synthetic_dataset::programs
