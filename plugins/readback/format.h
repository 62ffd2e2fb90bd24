#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/expected_labels.h"
#include "plugins/readback/found_files.h"
#include "plugins/readback/written_scene.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::formats {

/// The labels that a writer's files should have of a scene, as its measures say.
using Expectation = std::function<ExpectedLabels(const MeasuredScene& scene)>;

/// What programs know of a format beside its writer. Each folder of a format has a namespace of its
/// name with a function `Format format()` in it, from which CMake makes the list of all.
struct Format {
  std::string type;  ///< of its writer, as plugins.xml has it: "synthetic_dataset/Yolo"

  /// Whether labels can only be read when the files of the dataset as a whole are there.
  bool needs_dataset_files = false;

  /// Reads what a writer made of a scene from its files alone.
  /// @throws Error naming the file that is missing or not as the format has it
  LabelledPicture (*read)(const WrittenScene& scene) = nullptr;

  /// @param parameters  the writer's, which it has accepted
  Expectation (*expectation)(Parameters& parameters,
                             const std::vector<ClassInfo>& classes) = nullptr;

  /// Holds all values of the files against the truth; null where nobody has said what they should
  /// be.
  /// @param parameters  the writer's, which it has accepted
  std::unique_ptr<ValueCheck> (*values)(Parameters& parameters,
                                        const DatasetInfo& dataset) = nullptr;
};

/// The name of each format's folder, under which users know it ("pascal_voc"), and its writer's
/// type.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& formatNames();

/// The format of a type of writer; null where it is none of this package's.
[[nodiscard]] const Format* formatOf(const std::string& writer_type);

}  // namespace synthetic_dataset::formats
