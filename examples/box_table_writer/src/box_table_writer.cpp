#include <optional>
#include <ostream>
#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace box_table_writer {

using namespace synthetic_dataset;

/// Writes `images/N.png`, and a table with a row for each visible object: the box around its
/// visible pixels.
class BoxTableWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& /*dataset*/) override {
    table_ = parameters.requiredFile("table");
    decimals_ = parameters.optionalBetween("decimals", 1, 0, 9);
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
      const std::optional<Box> box = object.visibleBox();
      if (!object.labelled() || !box) continue;
      std::string row = image + "," + object.name + "," + object.class_name;
      for (const double edge : {box->left, box->top, box->right, box->bottom}) {
        row += "," + fixed(edge, decimals_);
      }
      output.addRecord("rows", row);
    }
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFileAtParameter(table_, [&](std::ostream& table) {
      table << "image,object,class,left,top,right,bottom\n";
      records.forEach(
          "rows", [&](std::int64_t /*scene*/, const std::string& row) { table << row << '\n'; });
    });
  }

  FileParameter table_;
  int decimals_ = 1;
};

}  // namespace box_table_writer

PLUGINLIB_EXPORT_CLASS(box_table_writer::BoxTableWriter, synthetic_dataset::LabelWriter)
