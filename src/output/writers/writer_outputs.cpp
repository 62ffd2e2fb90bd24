#include "output/writers/writer_outputs.h"

#include <utility>

#include "base/image/image_encoder.h"
#include "base/image/png_encoder.h"
#include "output/files/file_name_rules.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/relative_path.h"

namespace synthetic_dataset::output {

ClaimedPaths::ClaimedPaths(std::string folder) : folder_(std::move(folder)) {}

std::string ClaimedPaths::claim(const std::string& path) {
  std::string file = absolute(path);
  if (!claimed_.insert(path).second) throw Error("the path '" + path + "' was used twice");
  return file;
}

std::string ClaimedPaths::absolute(const std::string& path) const {
  if (const auto problem = relativePathProblem(path)) {
    throw Error("the path '" + path + "' cannot be used: " + *problem);
  }
  return folder_ + path;
}

GatheringSceneOutput::GatheringSceneOutput(std::size_t writer, const WriterParameters& parameters,
                                           output::SceneFiles& files,
                                           std::vector<std::string>& warnings)
    : writer_(writer),
      name_(parameters.writerName()),
      paths_(output::absolutePath(parameters.outputFolder())),
      files_(files),
      warnings_(warnings) {}

void GatheringSceneOutput::addImage(const std::string& path, const cv::Mat& image) {
  std::string file = paths_.claim(path);
  if (const auto problem = base::imageProblem(path, image)) {
    throw Error("the image '" + path + "' cannot be written: " + *problem);
  }
  files_.files.push_back({writer_, std::move(file), image, {}, {}});
}

void GatheringSceneOutput::addMask(const std::string& path, const Mask& mask) {
  std::string file = paths_.claim(path);
  if (const auto problem = base::imageProblem(path, mask)) {
    throw Error("the mask '" + path + "' cannot be written: " + *problem);
  }
  files_.files.push_back({writer_, std::move(file), {}, {}, {}, mask});
}

void GatheringSceneOutput::addIndexedImage(const std::string& path, const cv::Mat& indices,
                                           const std::vector<cv::Vec3b>& palette) {
  std::string file = paths_.claim(path);
  if (const auto problem = base::indexedImageProblem(path, indices, palette)) {
    throw Error("the image '" + path + "' cannot be written: " + *problem);
  }
  files_.files.push_back({writer_, std::move(file), indices, {}, palette});
}

void GatheringSceneOutput::addText(const std::string& path, std::string text) {
  files_.files.push_back({writer_, paths_.claim(path), {}, std::move(text), {}});
}

void GatheringSceneOutput::addRecord(const std::string& channel, std::string record) {
  if (channel.find('\n') != std::string::npos) {
    throw Error("the records' channel '" + channel + "' has more than one line");
  }
  files_.records.push_back({writer_, channel, std::move(record)});
}

void GatheringSceneOutput::addWarning(const std::string& kind) {
  warnings_.push_back("writer '" + name_ + "': " + kind);
}

StoringDatasetOutput::StoringDatasetOutput(std::size_t writer, const WriterParameters& parameters,
                                           output::DatasetStore& store)
    : writer_(writer),
      parameters_(parameters),
      paths_(output::absolutePath(parameters.outputFolder())),
      store_(store) {}

void StoringDatasetOutput::addFile(const std::string& path, const Content& content) {
  store_.writeDatasetFile(writer_, paths_.claim(path), content);
}

void StoringDatasetOutput::addFileAtParameter(const FileParameter& file, const Content& content) {
  if (parameters_.files().count(file.path()) == 0) {
    throw Error("addFileAtParameter: the file '" + file.path() +
                "' was not read from this writer's parameters with requiredFile");
  }
  store_.writeDatasetFile(writer_, file.path(), content);
}

void StoringDatasetOutput::addFileByName(
    const std::string& path, const std::function<void(const std::string& file)>& write) {
  store_.writeDatasetFileByName(writer_, paths_.claim(path), write);
}

void StoringDatasetOutput::addLink(const std::string& path, const std::string& scene_file) {
  store_.linkDatasetFile(writer_, paths_.claim(path), paths_.absolute(scene_file));
}

std::string StoringDatasetOutput::readFile(const std::string& scene_file) const {
  return store_.readSceneFile(writer_, paths_.absolute(scene_file));
}

}  // namespace synthetic_dataset::output
