#include <cstdlib>
#include <ostream>
#include <stdexcept>

#include <pluginlib/class_list_macros.hpp>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::test {

/// Misbehaves in the way that the parameter `fault` names.
class MisbehavingWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& /*dataset*/) override {
    fault_ = parameters.optional<std::string>("fault", "none");
    frames_ =
        parameters.maybe<std::vector<std::string>>("frames").value_or(std::vector<std::string>());
    if (fault_ == "initialize") throw Error("there is no calibration");
    if (parameters.has("list")) list_ = parameters.requiredFile("list");
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.silhouettes = fault_ == "greedy";
    requirements.frames = frames_;
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    if (fault_ == "throw") throw std::out_of_range("vector::at");
    if (fault_ == "exit") std::exit(0);
    if (fault_ == "throw a number") throw 42;
    if (fault_ == "leave the folder") output.addText("../outside.txt", "");
    if (fault_ == "same path twice") output.addImage("same.png", scene.image);
    if (fault_ == "float pixels") output.addImage("0.png", cv::Mat(2, 2, CV_32FC1));
    if (fault_ == "other format") output.addImage("0.bmp", scene.image);
    output.addImage("same.png", scene.image);
    output.addText("same.txt", "label");
    if (fault_ == "channel of two lines") output.addRecord("a\nb", "record");
    output.addRecord("all", "record");
    output.addWarning("alpha: strange");
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    if (fault_ == "unknown parameter")
      output.addFileAtParameter(FileParameter(), [](std::ostream&) {});
    if (fault_ == "absolute path") output.addFile("/etc/list", [](std::ostream&) {});
    const auto all = [&](std::ostream& stream) {
      records.forEach("all", [&](std::int64_t scene, const std::string& record) {
        stream << scene << " " << record << "\n";
      });
    };
    output.addFile("all.txt", all);
    if (fault_ == "same file twice") output.addFile("all.txt", all);
    if (fault_ == "write the list") output.addFileAtParameter(list_, all);
  }

  std::string fault_;
  FileParameter list_;
  std::vector<std::string> frames_;
};

}  // namespace synthetic_dataset::test

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::test::MisbehavingWriter, synthetic_dataset::LabelWriter)
