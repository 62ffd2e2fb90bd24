#include "plugins/ultralytics/ultralytics_yaml.h"

#include <algorithm>

#include "plugins/shared/json.h"

namespace synthetic_dataset {
namespace {

/// A double-quoted text; YAML reads JSON strings.
std::string quoted(const std::string& text) { return jsonText(text); }

template <class List, class TextOf>
std::string listOf(const List& list, TextOf textOf) {
  std::string text = "[";
  for (const auto& each : list) text += (text.size() > 1 ? ", " : "") + textOf(each);
  return text + "]";
}

/// The loader requires `train` and `val`; one without images refers to another split's.
void writeSplits(std::ostream& stream, const std::vector<std::string>& splits) {
  const auto has = [&](const std::string& split) {
    return std::find(splits.begin(), splits.end(), split) != splits.end();
  };
  const std::string first = splits.empty() ? "train" : splits.front();
  for (const std::string split : {"train", "val"}) {
    stream << split << ": images/" << (has(split) ? split : first);
    if (!has(split)) {
      stream << "  # the loader wants it, and the dataset has no images of this split";
    }
    stream << '\n';
  }
  for (const std::string& split : splits) {
    if (split != "train" && split != "val") stream << split << ": images/" << split << '\n';
  }
}

}  // namespace

KeypointColumns keypointColumns(const DatasetInfo& dataset, std::size_t class_count) {
  KeypointColumns result;
  result.names.resize(class_count);
  std::size_t count = 0;
  for (const ObjectInfo& object : dataset.objects) {
    std::vector<std::string>& of_class = result.names.at(static_cast<std::size_t>(object.class_id));
    std::vector<std::size_t> columns;
    for (const std::string& name : object.keypoint_names) {
      const auto known = std::find(of_class.begin(), of_class.end(), name);
      columns.push_back(static_cast<std::size_t>(known - of_class.begin()));
      if (known == of_class.end()) of_class.push_back(name);
    }
    count = std::max(count, of_class.size());
    result.of_objects.push_back(std::move(columns));
  }
  for (std::vector<std::string>& of_class : result.names) {
    while (of_class.size() < count) of_class.push_back("unused_" + std::to_string(of_class.size()));
  }
  return result;
}

void writeUltralyticsYaml(std::ostream& stream, const UltralyticsDataset& dataset) {
  stream
      << "# Ultralytics looks for the images beside this file: as there is no `path`, the folder "
         "can be moved.\n";
  writeSplits(stream, dataset.splits);
  stream << "names:\n";
  for (std::size_t i = 0; i < dataset.names.size(); ++i) {
    stream << "  " << std::to_string(i) << ": " << quoted(dataset.names[i]) << '\n';
  }
  if (dataset.keypoint_count == 0) return;
  const auto number = [](std::size_t each) { return std::to_string(each); };
  stream << "kpt_shape: [" << number(dataset.keypoint_count) << ", 3]\n"
         << "flip_idx: " << listOf(dataset.flip_idx, number) << '\n'
         << "kpt_names:\n";
  for (std::size_t i = 0; i < dataset.kpt_names.size(); ++i) {
    stream << "  " << std::to_string(i) << ": " << listOf(dataset.kpt_names[i], quoted) << '\n';
  }
}

}  // namespace synthetic_dataset
