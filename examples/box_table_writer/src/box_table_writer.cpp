#include <ostream>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace box_table_writer {

using namespace synthetic_dataset;

/// `images/N.png`, and a table with a row for each object that is to be seen: the box round its
/// visible pixels.
class BoxTableWriter : public LabelWriter {
 private:
  void doInitialize(const WriterParameters& parameters, const DatasetInfo& /*dataset*/) override {
    (void)parameters.requiredFile("table");
    decimals_ = parameters.optional("decimals", 1);
    if (decimals_ < 0 || decimals_ > 9) {
      parameters.addError("decimals",
                          "found " + std::to_string(decimals_) + "; it should be 0 to 9");
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.visible_masks = true;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    const std::string image = "images/" + scene.name + ".png";
    output.addImage(image, scene.image);
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled() || !object.visible_box) continue;
      std::string row = image + "," + object.name + "," + object.class_name;
      const Box& box = *object.visible_box;
      for (const double edge : {box.left, box.top, box.right, box.bottom}) {
        row += "," + fixed(edge, decimals_);
      }
      output.addRecord(row);
    }
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFileAtParameter("table", [&](std::ostream& table) {
      table << "image,object,class,left,top,right,bottom\n";
      records.forEach(
          [&](std::int64_t /*scene*/, const std::string& row) { table << row << '\n'; });
    });
  }

  int decimals_ = 1;
};

}  // namespace box_table_writer

PLUGINLIB_EXPORT_CLASS(box_table_writer::BoxTableWriter, synthetic_dataset::LabelWriter)
