#include "plugins/ros_bag/ros_bag_values.h"

#include <string>
#include <utility>

namespace synthetic_dataset::formats::ros_bag {
namespace {

class RosBagValues : public ValueCheck {
 public:
  RosBagValues(std::string file, bool has_depth) : file_(std::move(file)), has_depth_(has_depth) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    files.compareWithScene("images/" + scene.name + ".png", truth);
    files.comparePicture("instances/" + scene.name + ".png", scene.instance_map());
    if (has_depth_) files.compareWithScene("depth/" + scene.name + ".tiff", truth, "depth");
  }

  void checkDataset(FoundFiles& files) override { (void)files.take(file_); }

 private:
  std::string file_;
  bool has_depth_;
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& /*dataset*/) {
  std::string file = parameters.optional<std::string>("file", "dataset.bag");
  return std::make_unique<RosBagValues>(std::move(file), parameters.optional("depth", true));
}

}  // namespace synthetic_dataset::formats::ros_bag
