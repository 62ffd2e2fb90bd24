#include "plugins/bounding_shape/bounding_shape_values.h"

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::bounding_shape {
namespace {

class BoundingShapeValues : public ValueCheck {
 public:
  BoundingShapeValues(std::string output_frame, std::string global_frame)
      : output_frame_(std::move(output_frame)), global_frame_(std::move(global_frame)) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    constexpr int kDecimals = 5;
    const Scene& scene = truth.scene;
    const Pose X_FG = scene.transform(output_frame_, global_frame_);
    std::string lines;
    for (const SceneObject& object : scene.objects) {
      if (!object.X_GO || object.dropped) continue;
      lines += object.id;
      for (const Eigen::Vector3d& p_O : object.bounding_shape_O) {
        const Eigen::Vector3d p_F = X_FG * (*object.X_GO * p_O);
        for (int i = 0; i < 3; ++i) lines += " " + fixed(p_F(i), kDecimals);
      }
      lines += "\n";
    }
    files.compareWithScene(scene.name + ".png", truth);
    files.compareText(scene.name + ".txt", lines);
  }

  void checkDataset(FoundFiles& /*files*/) override {}

 private:
  std::string output_frame_;
  std::string global_frame_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  return std::make_unique<BoundingShapeValues>(parameters.required<std::string>("output_frame"),
                                               dataset.global_frame);
}

}  // namespace synthetic_dataset::formats::bounding_shape
