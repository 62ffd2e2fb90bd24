#include "plugins/stvnet/stvnet_values.h"

#include <optional>

#include "plugins/shared/pixel_origin.h"
#include "plugins/stvnet/stvnet_folder.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::stvnet {
namespace {

class StvNetValues : public ValueCheck {
 public:
  explicit StvNetValues(PixelOrigin origin) : origin_(origin) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    for (const SceneObject& object : scene.objects) {
      if (!object.X_CO || !object.in_view || object.dropped) continue;
      const auto line = lineOf(object, scene.camera);
      if (!line) continue;  // a keypoint is behind the camera
      const std::string folder = stvNetFolder(object.name);
      files.compareWithScene(folder + "/JPEGImages/" + scene.name + ".png", truth);
      files.compareMask(folder + "/mask/" + scene.name + ".png", object.silhouette());
      files.compareText(folder + "/labels/" + scene.name + ".txt", *line);
    }
  }

  void checkDataset(FoundFiles& /*files*/) override {}

 private:
  [[nodiscard]] std::optional<std::string> lineOf(const SceneObject& object,
                                                  const CameraModel& camera) const {
    constexpr int kDecimals = 5;
    std::string line = object.id;
    for (const Eigen::Vector3d& p_O : object.keypoints_O) {
      const auto pixel = camera.project(*object.X_CO * p_O);
      if (!pixel) return std::nullopt;
      line += " " + fixed((pixel->x() + origin_.offset) / camera.width(), kDecimals);
      line += " " + fixed((pixel->y() + origin_.offset) / camera.height(), kDecimals);
    }
    return line + " \n";
  }

  PixelOrigin origin_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& /*dataset*/) {
  return std::make_unique<StvNetValues>(readPixelOrigin(parameters));
}

}  // namespace synthetic_dataset::formats::stvnet
