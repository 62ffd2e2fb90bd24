#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/diagnostics.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/camera_model.h"
#include "synthetic_dataset/cuboid.h"
#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::base {

/// One of an object's keypoints as the camera sees it.
struct KeypointFacts {
  Eigen::Vector3d p_O = Eigen::Vector3d::Zero();  ///< [m]
  std::optional<Eigen::Vector2d> pixel = {};
  std::optional<KeypointState> state = {};
};

/// How much of the objects in recorded pictures is hidden (label::ObjectCover).
struct CoverFacts {
  double unmeasured = 0.0;  ///< the share of their pixels at which nothing was measured, 0 .. 1
  double covered = 0.0;     ///< the share of their pixels that something unknown hides, 0 .. 1
};

/// The measurements of an object in a scene, named as in SceneObject; nullopt if nobody asked for
/// them.
struct ObjectFacts {
  std::optional<Pose> X_GO = Pose::Identity();
  std::optional<double> distance = 0.0;  ///< [m]; nullopt without a pose
  bool dropped = false;
  std::optional<Box> loose_box = {};
  std::optional<Box> silhouette_box = {};
  std::optional<Box> visible_box = {};
  std::optional<std::int64_t> silhouette_pixels = {};
  std::optional<std::int64_t> visible_pixels = {};
  std::optional<double> visibility = {};
  std::optional<double> truncation = {};

  /// Intersection over union of its visible mask from background subtraction and the exact one.
  std::optional<double> mask_agreement = {};

  /// How well its outline matches the edges of a recorded picture, 0 .. 1 (label::Alignment).
  std::optional<double> alignment = {};
  std::optional<CoverFacts> cover = {};  ///< in a recorded picture; nullopt if it has no pixels

  Cuboid cuboid_O = {};
  std::vector<Eigen::Vector3d> bounding_shape_O = {};
  std::vector<KeypointFacts> keypoints = {};
  std::optional<std::int64_t> silhouette_in_image = {};  ///< [px]
  std::optional<Mask> silhouette = {};
  std::optional<Mask> visible_mask = {};
};

/// What is known about one of a scene's pictures without its pixels.
struct PictureFacts {
  std::string name;         ///< as in Scene: "image", "depth"; "image.jpg" is its JPEG file
  std::string digest = "";  ///< SHA-256 of its pixels, row by row, or of a file's bytes
  /// For depth: its cells, each with sum, least and greatest [m]. For a cloud's labels: how many
  /// points each object has, up to the last object that has any.
  std::vector<float> cells = {};
};

/// Two things that intersect.
struct ContactFacts {
  std::string first;
  std::string second;
  double depth = 0.0;  ///< [m]
};

/// What a scene drew for a random entry of the settings.
struct DrawFacts {
  std::string name;   ///< the entry's full name, such as "lights/sun/intensity"; once in a scene
  std::string value;  ///< JSON: a number, a list of numbers or a text in quotes
};

/// What is known about a scene besides its files.
struct SceneFacts {
  std::int64_t index = 0;
  Stamp stamp{0};
  std::int64_t instant = 0;  ///< index of its time among the run's times
  std::string camera = "camera";
  int width = 1;   ///< of the image [px], > 0
  int height = 1;  ///< of the image [px], > 0
  std::string split = "";
  std::uint64_t seed = 0;  ///< of everything random in it
  Pose X_GC = Pose::Identity();
  std::vector<ObjectFacts> objects = {};
  std::vector<ContactFacts> contacts = {};
  std::vector<DrawFacts> draws = {};
  std::vector<Warning> warnings = {};
  std::optional<double> alignment = {};  ///< of all outlines together
  std::optional<CoverFacts> cover = {};  ///< of all objects together

  std::optional<CameraModel> camera_model = {};
  std::map<std::string, Pose> frames = {};        ///< X_GF of the frames that writers ask for
  std::map<std::string, cv::Mat> pictures = {};   ///< the rendered ones, by name in Scene
  std::map<std::string, cv::Mat> link_maps = {};  ///< "world_map" and "part_map", as in Scene
  std::vector<PictureFacts> known_pictures = {};  ///< if it was read from a manifest

  [[nodiscard]] Box imageBounds() const { return {-0.5, -0.5, width - 0.5, height - 0.5}; }
};

/// The facts about an object that a scene contains: all but `mask_agreement`.
[[nodiscard]] ObjectFacts objectFacts(const SceneObject& object);

/// The facts that every scene contains, without its objects.
[[nodiscard]] SceneFacts sceneFacts(const Scene& scene);

}  // namespace synthetic_dataset::base
