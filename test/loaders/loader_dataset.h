#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "support/bag_builder.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/pose.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// The camera of these datasets, 320 x 240 pixels: small enough to be quick, and with its centre
/// off the image's so that a mixed-up axis shows.
struct LoaderCamera {
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;
  static constexpr double kFocalLength = 280.0;
  static constexpr double kCentreU = 155.5;
  static constexpr double kCentreV = 121.0;

  /// The point that falls on a pixel, at a depth z [m], in the optical frame.
  [[nodiscard]] static Eigen::Vector3d behind(double u, double v, double z) {
    return {(u - kCentreU) / kFocalLength * z, (v - kCentreV) / kFocalLength * z, z};
  }
};

/// A visual of a model: its pose in the model (SDF's six numbers) and its geometry.
struct LoaderVisual {
  std::string pose;
  std::string geometry;
};

[[nodiscard]] LoaderVisual boxVisual(const std::string& pose, const std::string& size);
[[nodiscard]] LoaderVisual sphereVisual(const std::string& pose, double radius);

/// An object of such a dataset.
struct LoaderObject {
  std::string name;
  std::string class_name;
  std::string colour;  ///< three numbers, 0 to 1
  std::vector<LoaderVisual> visuals;
  std::vector<Eigen::Vector3d> keypoints_O;
  std::string model;  ///< the text of a URDF model instead of visuals
};

/// A run in the making: objects, and where they are at each of its times, four a second.
///
/// A camera named `front` stands in the origin of `map`, and its optical frame is that of `map`:
/// x right, y down, z ahead.
class LoaderDataset {
 public:
  explicit LoaderDataset(const std::vector<LoaderObject>& objects);

  /// Adds something that is no object. The text is that of SDF elements.
  void addToWorld(const std::string& sdf) { world_ += sdf; }

  /// Adds a time. Objects that are not named stand behind the camera.
  /// @param X_GO  by the objects' names
  /// @param links  X_OL by the names of links, of the objects that are articulated
  void addTime(const std::map<std::string, Pose>& X_GO,
               const std::map<std::string, Pose>& links = {});

  /// A second camera, beside the first.
  void addCamera(const std::string& name, const Pose& X_GC);

  /// Gives all cameras a lens: plumb_bob's five coefficients.
  void setDistortion(const std::array<double, 5>& coefficients) { distortion_ = coefficients; }

  /// Parameters beside those that every dataset has.
  void set(const std::string& name, const Value& value) { parameters_[name] = value; }

  /// Makes the dataset with all writers of writers.yaml; with lidars, with those that are marked by
  /// `lidar` there, else with the others.
  void generate(const std::filesystem::path& folder) const;

 private:
  struct Time {
    std::map<std::string, Pose> X_GO;
    std::map<std::string, Pose> links;
  };

  [[nodiscard]] std::string worldText() const;
  [[nodiscard]] std::string writeBag(const TemporaryFolder& inputs) const;
  void record(const Time& time, Stamp stamp, BagBuilder& bag) const;

  std::vector<LoaderObject> objects_;
  std::string world_;
  std::vector<Time> times_;
  std::map<std::string, Pose> cameras_;
  std::array<double, 5> distortion_{};
  Value::Map parameters_;
};

}  // namespace synthetic_dataset::test
