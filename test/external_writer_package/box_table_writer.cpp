#include <ostream>

#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace external_writer_package {

/// Writes `boxes.csv`: scene, object, left, top, right and bottom in pixels.
class BoxTableWriter : public synthetic_dataset::LabelWriter {
  void doWriteScene(const synthetic_dataset::Scene& scene,
                    synthetic_dataset::SceneOutput& output) const override {
    using synthetic_dataset::fixed;
    for (const synthetic_dataset::SceneObject& object : scene.objects) {
      if (!object.in_view) continue;
      const synthetic_dataset::Box& box = *object.loose_box;
      output.addRecord(std::to_string(scene.index) + "," + object.name + "," + fixed(box.left, 2) +
                       "," + fixed(box.top, 2) + "," + fixed(box.right, 2) + "," +
                       fixed(box.bottom, 2) + "\n");
    }
  }

  void doFinalize(const synthetic_dataset::SceneRecords& records,
                  synthetic_dataset::DatasetOutput& output) const override {
    output.addFile("boxes.csv", [&](std::ostream& file) {
      records.forEach([&](std::int64_t, const std::string& line) { file << line; });
    });
  }
};

}  // namespace external_writer_package

PLUGINLIB_EXPORT_CLASS(external_writer_package::BoxTableWriter, synthetic_dataset::LabelWriter)
