#include "verification/scene_verifier.h"

#include <filesystem>

#include <opencv2/imgcodecs.hpp>

#include "config/yaml_value.h"
#include "output/manifest/manifest_paths.h"
#include "plugins/readback/files.h"
#include "plugins/readback/format_readers.h"
#include "synthetic_dataset/label_text.h"
#include "verification/expected_labels.h"
#include "verification/label_checks.h"

namespace synthetic_dataset {
namespace {

/// The settings of a run by their names.
std::map<std::string, Value> settingValues(const output::RunDescription& run) {
  std::map<std::string, Value> values;
  for (const auto& [name, setting] : run.settings) {
    values[name] = config::parseYaml(setting.value, "setting '" + name + "'");
  }
  return values;
}

/// Whether a file is a picture, by its name.
bool isPicture(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg" ||
         extension == ".tiff" || extension == ".tif";
}

std::string text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// As Scene::name: with the camera's folder where there are several.
std::string sceneName(const output::SceneFacts& scene, std::size_t camera_count) {
  return (camera_count > 1 ? scene.camera + "/" : "") + sceneNumber(scene.instant);
}

}  // namespace

SceneVerifier::SceneVerifier(const output::ListedDataset& dataset, VerificationDepth depth,
                             VerificationListener& listener, VerificationCounts& counts)
    : dataset_(dataset),
      depth_(depth),
      listener_(listener),
      counts_(counts),
      settings_(settingValues(dataset.content().run)),
      kept_(readback::keptFiles()) {
  const output::ManifestContent& content = dataset.content();
  if (depth_ != VerificationDepth::kLabels || content.scene_count == 0) return;
  std::string unread;
  for (const output::StoreWriter& writer : content.writers) {
    if (hasLabelRules(writer.type) && !hasReadableLabels(writer)) {
      unread += (unread.empty() ? "'" : ", '") + writer.name + "'";
    }
  }
  if (unread.empty()) return;
  listener_.remark("'" + dataset.manifest() + "': the labels of " + unread +
                   " are not checked: they need files that only a whole, complete dataset has");
}

bool SceneVerifier::hasReadableLabels(const output::StoreWriter& writer) const {
  const output::ManifestContent& content = dataset_.content();
  const bool has_dataset_files = content.complete && !content.shard;
  return hasLabelRules(writer.type) && (has_dataset_files || !needsDatasetFiles(writer.type));
}

void SceneVerifier::verifyDatasetFiles() {
  // Before the end they may be announced and not be there yet.
  if (!dataset_.content().complete) return;
  dataset_.forEachFileOf(std::nullopt, [&](const output::ListedFile& file) {
    WrittenFiles files;
    verifyFile(file, files);
  });
}

void SceneVerifier::verifyFile(const output::ListedFile& file, WrittenFiles& of_writer) {
  ++counts_.files;
  const std::string path_problem = output::pathProblem(file, dataset_);
  if (!path_problem.empty()) {
    listener_.problem("'" + dataset_.manifest() + "': the listed path '" + file.path + "' " +
                      path_problem);
    of_writer.are_readable = false;
    return;
  }
  const std::string& folder = dataset_.folder();
  const std::string path = output::absoluteFrom(folder, file.path);
  const output::FileFinding finding = output::checkFile(
      path, file.linked_to ? output::absoluteFrom(folder, *file.linked_to) : "", file,
      depth_ == VerificationDepth::kSizes ? output::FileCheck::kSize : output::FileCheck::kContent);
  if (!finding.problem.empty()) {
    listener_.problem("'" + path + "' " + finding.problem);
  }
  of_writer.are_readable = of_writer.are_readable && finding.is_readable;
  of_writer.listed.push_back(file);
  of_writer.paths.push_back(path);
}

void SceneVerifier::verifyScene(const output::SceneFacts& scene) {
  ++counts_.scenes;
  const auto& writers = dataset_.content().writers;
  std::vector<WrittenFiles> files(writers.size());
  dataset_.forEachFileOf(scene.index, [&](const output::ListedFile& file) {
    if (file.writer < files.size()) verifyFile(file, files[file.writer]);
  });
  if (depth_ != VerificationDepth::kLabels) return;
  const cv::Size size(scene.width, scene.height);
  for (std::size_t i = 0; i < writers.size(); ++i) {
    if (!files[i].are_readable) continue;
    const std::string origin =
        "scene " + std::to_string(scene.index) + ", writer '" + writers[i].name + "': ";
    try {
      verifyPictures(writers[i], files[i], size);
      if (hasReadableLabels(writers[i])) verifyLabels(origin, scene, writers[i], files[i], size);
    } catch (const std::exception& error) {
      listener_.problem(origin + error.what());
    }
  }
}

void SceneVerifier::verifyPictures(const output::StoreWriter& writer, const WrittenFiles& files,
                                   const cv::Size& size) {
  const bool is_ours = writer.type.rfind("synthetic_dataset/", 0) == 0;
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    if (!isPicture(files.paths[i]) || files.listed[i].linked_to) continue;
    const cv::Mat picture = readback::readPicture(files.paths[i], cv::IMREAD_UNCHANGED);
    if (is_ours && picture.size() != size) {
      listener_.problem("'" + files.paths[i] + "' is a picture of " + text(picture.size()) +
                        " pixels; it should be of its camera's " + text(size));
    }
  }
}

void SceneVerifier::verifyLabels(const std::string& origin, const output::SceneFacts& scene,
                                 const output::StoreWriter& writer, const WrittenFiles& files,
                                 const cv::Size& size) {
  const output::RunDescription& run = dataset_.content().run;
  readback::WrittenScene written{writer.output_folder,
                                 sceneName(scene, run.cameras.size()),
                                 scene.instant,
                                 {files.paths.begin(), files.paths.end()},
                                 kept_};
  const ExpectedLabels expected = expectedLabels(scene, {run, settings_, writer, size});
  if (written.files.empty()) {
    // Formats with a folder for each object have none of a scene without labels.
    for (const std::string& problem : labelProblems({}, expected)) {
      listener_.problem(origin + problem);
    }
    return;
  }
  const readback::LabelledPicture picture = readback::readerOf(writer.type)(written);
  counts_.labels += static_cast<std::int64_t>(picture.labels.size());
  for (const std::string& problem : labelProblems(picture, expected)) {
    listener_.problem(origin + problem);
  }
}

}  // namespace synthetic_dataset
