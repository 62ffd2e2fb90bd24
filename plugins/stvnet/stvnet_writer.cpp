#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/shared/pixel_origin.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

bool isControl(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20U || code == 0x7FU;
}

/// An object's folder: its name or, if that cannot be a path, a safe one. A name with slashes
/// yields nested folders, as it always has.
std::string stvNetFolder(const std::string& name) {
  constexpr std::size_t kLongest = 200;  // [byte] of a path component, of 255 allowed
  bool is_path = std::none_of(name.begin(), name.end(), isControl);
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::size_t length = end - begin;
    is_path = is_path && length > 0 && length <= kLongest && name[begin] != '.';
    begin = end + 1;
  }
  return is_path && name.size() <= 4 * kLongest ? name : safeFileName(name);
}

}  // namespace

/// stvNet: for each object a folder with `JPEGImages/N.png` (PNG despite the name), `mask/N.png`
/// and `labels/N.txt`: the id, then each keypoint's position as fractions of the image, counted
/// from the first pixel's centre or from the image's edge.
class StvNetWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& /*dataset*/) override {
    parameters.ignore("tf_timeout");  // a parameter of nn_data_collection
    origin_ = readPixelOrigin(parameters);
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.silhouettes = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    for (const SceneObject& object : scene.objects) {
      if (!object.X_CO || !object.inView(scene.camera) || object.dropped) continue;
      if (object.keypoints_O.size() != kKeypoints) {
        output.addWarning(object.name + ": stvNet reads " + std::to_string(kKeypoints) +
                          " keypoints of an object, and this one has " +
                          std::to_string(object.keypoints_O.size()));
      }
      const auto text = label(object, scene.camera);
      if (!text) {
        output.addWarning(object.name +
                          ": a keypoint is behind the camera; samples like this are left out");
        continue;
      }
      const std::string folder = stvNetFolder(object.name);
      output.addImage(folder + "/JPEGImages/" + scene.name + ".png", scene.image);
      output.addMask(folder + "/mask/" + scene.name + ".png", object.silhouette());
      output.addText(folder + "/labels/" + scene.name + ".txt", *text);
    }
  }

  /// An object's line, with keypoints not limited to the image; nothing if a keypoint does not
  /// project onto the image plane.
  [[nodiscard]] std::optional<std::string> label(const SceneObject& object,
                                                 const CameraModel& camera) const {
    std::string text = object.id + " ";
    for (const Keypoint& keypoint : object.keypoints) {
      const auto& pixel = keypoint.pixel;
      if (!pixel) return std::nullopt;
      text += fixed((pixel->x() + origin_.offset) / camera.width(), 5) + " " +
              fixed((pixel->y() + origin_.offset) / camera.height(), 5) + " ";
    }
    return text + "\n";
  }

  static constexpr std::size_t kKeypoints = 9;  ///< number that stvNet's data.py takes from a label

  PixelOrigin origin_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::StvNetWriter, synthetic_dataset::LabelWriter)
