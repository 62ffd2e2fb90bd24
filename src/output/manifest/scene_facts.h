#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "output/manifest/run_description.h"
#include "synthetic_dataset/box.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::output {

/// What was measured of an object in a scene; what nobody asked for is nothing. The members are
/// those of SceneObject.
struct ObjectFacts {
  Pose X_GO = Pose::Identity();
  double distance = 0.0;  ///< [m]
  bool in_view = false;
  bool dropped = false;
  std::optional<Box> loose_box = {};
  std::optional<Box> silhouette_box = {};
  std::optional<Box> visible_box = {};
  std::optional<std::int64_t> silhouette_pixels = {};
  std::optional<std::int64_t> visible_pixels = {};
  std::optional<double> visibility = {};
  std::optional<double> truncation = {};

  /// Intersection over union of its visible mask by background subtraction with the exact one.
  std::optional<double> mask_agreement = {};
};

/// Two things that are inside one another.
struct ContactFacts {
  std::string first;
  std::string second;
  double depth = 0.0;  ///< [m]
};

/// What was drawn for a scene of an entry of the settings that is random.
struct DrawFacts {
  std::string name;   ///< the entry's full name, such as "lights/sun/intensity"; once in a scene
  std::string value;  ///< JSON: a number, a list of numbers or a text in quotes
};

/// What the manifest has of a scene beside its files.
struct SceneFacts {
  std::int64_t index = 0;
  Stamp stamp{0};
  std::int64_t instant = 0;  ///< index of its time among the run's times
  std::string camera = "camera";
  int width = 1;   ///< of the image [px], > 0
  int height = 1;  ///< of the image [px], > 0
  std::string split = "";
  std::uint64_t seed = 0;  ///< of all that is random in it
  Pose X_GC = Pose::Identity();
  std::vector<ObjectFacts> objects = {};
  std::vector<ContactFacts> contacts = {};
  std::vector<DrawFacts> draws = {};
  std::vector<Warning> warnings = {};
};

/// What a scene knows of an object, but for `mask_agreement`.
[[nodiscard]] ObjectFacts objectFacts(const SceneObject& object);

/// What every scene knows of itself, without its objects.
[[nodiscard]] SceneFacts sceneFacts(const Scene& scene);

}  // namespace synthetic_dataset::output
