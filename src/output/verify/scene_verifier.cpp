#include "output/verify/scene_verifier.h"

#include <algorithm>
#include <filesystem>

#include <opencv2/imgcodecs.hpp>

#include "output/files/digest.h"
#include "output/files/file_name_rules.h"
#include "output/manifest/manifest_paths.h"
#include "output/verify/label_checks.h"
#include "plugins/readback/files.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {
namespace {

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
      measured_(dataset.content().run),
      true_(dataset.content().run) {
  const output::ManifestContent& content = dataset.content();
  std::string unread;
  for (const output::StoreWriter& writer : content.writers) {
    labels_.push_back(labelsOf(writer));
    if (labels_.back().format == nullptr && formats::formatOf(writer.type) != nullptr) {
      unread += (unread.empty() ? "'" : ", '") + writer.name + "'";
    }
  }
  if (!content.has_truth && depth_ == VerificationDepth::kLabels) {
    listener_.remark("'" + dataset.manifest() + "': its format version is an earlier one: boxes, " +
                     "masks and poses are checked, and no other values of labels");
  }
  if (unread.empty() || depth_ != VerificationDepth::kLabels || content.scene_count == 0) return;
  listener_.remark("'" + dataset.manifest() + "': the labels of " + unread +
                   " are not checked: they need files that only a whole, complete dataset has");
}

SceneVerifier::Labels SceneVerifier::labelsOf(const output::StoreWriter& writer) const {
  const output::ManifestContent& content = dataset_.content();
  const formats::Format* format = formats::formatOf(writer.type);
  const bool has_dataset_files = content.complete && !content.shard;
  if (format == nullptr || (format->needs_dataset_files && !has_dataset_files)) return {};
  Parameters parameters = measured_.parametersOf(writer);
  Labels labels;
  labels.format = format;
  labels.expected = format->expectation(parameters, measured_.classes());
  labels.settings = measured_.settingsOf(writer);
  // A camera that cannot be is named among the manifest's rows.
  const bool has_cameras =
      std::all_of(content.run.cameras.begin(), content.run.cameras.end(),
                  [](const RunDescription::Camera& each) { return each.model.has_value(); });
  if (format->values != nullptr && content.has_truth && has_cameras) {
    labels.values = format->values(parameters, true_.dataset());
  }
  return labels;
}

void SceneVerifier::verifyDatasetFiles() {
  // Before the end they may be announced and not be there yet.
  if (!dataset_.content().complete) return;
  dataset_.forEachFileOf(std::nullopt, [&](const output::ListedFile& file) {
    WrittenFiles files;
    verifyFile(file, files);
    if (files.are_whole || depth_ != VerificationDepth::kLabels) return;
    Labels& labels = labels_.at(file.writer);
    labels.is_right = false;
    if (labels.format == nullptr || !labels.format->needs_dataset_files) return;
    labels.format = nullptr;
    listener_.remark("'" + dataset_.manifest() + "': the labels of '" +
                     dataset_.content().writers[file.writer].name +
                     "' are not checked: a file that they need is not as it was written");
  });
}

void SceneVerifier::verifyFile(const output::ListedFile& file, WrittenFiles& of_writer) {
  ++counts_.files;
  const std::string path_problem = output::pathProblem(file, dataset_);
  if (!path_problem.empty()) {
    listener_.problem("'" + dataset_.manifest() + "': the listed path '" + file.path + "' " +
                      path_problem);
    of_writer.are_readable = of_writer.are_whole = false;
    return;
  }
  const std::string& folder = dataset_.folder();
  const std::string path = output::absoluteFrom(folder, file.path);
  const output::FileFinding finding = output::checkFile(
      path, file.linked_to ? output::absoluteFrom(folder, *file.linked_to) : "", file,
      depth_ == VerificationDepth::kSizes ? output::FileCheck::kSize : output::FileCheck::kContent);
  if (!finding.problem.empty()) {
    listener_.problem("'" + path + "' " + finding.problem);
    of_writer.are_whole = false;
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
    if (!files[i].are_whole) labels_[i].is_right = false;
    if (!files[i].are_readable) continue;
    const std::string origin =
        "scene " + std::to_string(scene.index) + ", writer '" + writers[i].name + "': ";
    try {
      verifyPictures(writers[i], files[i], size);
      if (labels_[i].format != nullptr) verifyLabels(origin, scene, i, files[i]);
    } catch (const std::exception& error) {
      labels_[i].is_right = false;
      listener_.problem(origin + error.what());
    }
  }
}

void SceneVerifier::verifyPictures(const output::StoreWriter& writer, const WrittenFiles& files,
                                   const cv::Size& size) {
  const bool is_ours = writer.type.rfind("synthetic_dataset/", 0) == 0;
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    if (!isPicture(files.paths[i]) || files.listed[i].linked_to) continue;
    const cv::Mat picture = formats::readPicture(files.paths[i], cv::IMREAD_UNCHANGED);
    if (is_ours && picture.size() != size) {
      listener_.problem("'" + files.paths[i] + "' is a picture of " + text(picture.size()) +
                        " pixels; it should be of its camera's " + text(size));
    }
  }
}

void SceneVerifier::verifyLabels(const std::string& origin, const output::SceneFacts& scene,
                                 std::size_t writer, const WrittenFiles& files) {
  const output::StoreWriter& of = dataset_.content().writers[writer];
  const std::vector<output::RunDescription::Camera>& cameras = dataset_.content().run.cameras;
  const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                   [&](const auto& each) { return each.name == scene.camera; });
  const formats::WrittenScene written{of.output_folder,
                                      sceneName(scene, cameras.size()),
                                      static_cast<std::size_t>(camera - cameras.begin()),
                                      scene.stamp,
                                      {files.paths.begin(), files.paths.end()},
                                      kept_,
                                      labels_[writer].settings};
  const formats::ExpectedLabels expected = labels_[writer].expected(measured_.scene(scene, of));
  formats::LabelledPicture picture;
  // Formats with a folder for each object have none of a scene without labels.
  if (!written.files.empty()) picture = labels_[writer].format->read(written);
  counts_.labels += static_cast<std::int64_t>(picture.labels.size());
  const std::vector<std::string> problems = labelProblems(picture, expected);
  for (const std::string& problem : problems) {
    labels_[writer].is_right = false;
    listener_.problem(origin + problem);
  }
  // The rest of what is wrong with a wrong label would be found once more in other words.
  if (problems.empty() && files.are_whole) verifyValues(origin, scene, writer, files);
}

formats::FoundFiles SceneVerifier::foundFiles(std::size_t writer,
                                              const std::vector<std::string>& paths) const {
  const std::string& folder = dataset_.content().writers[writer].output_folder;
  std::vector<std::string> names;
  for (const std::string& path : paths) {
    names.push_back(liesWithin(path, folder) ? path.substr(folder.size()) : path);
  }
  return {folder, names, digestOfPixels, [](const std::string& bytes) { return digestOf(bytes); },
          kept_};
}

void SceneVerifier::verifyValues(const std::string& origin, const output::SceneFacts& scene,
                                 std::size_t writer, const WrittenFiles& files) {
  Labels& labels = labels_[writer];
  if (labels.values == nullptr) return;
  if (!scene.camera_model) {
    labels.is_right = false;
    listener_.problem(origin + "the manifest does not say with which camera it was made");
    return;
  }
  formats::FoundFiles found = foundFiles(writer, files.paths);
  labels.values->checkScene(true_.scene(scene, dataset_.content().writers[writer]), found);
  for (const std::string& problem : found.problems()) {
    labels.is_right = false;
    listener_.problem(origin + problem);
  }
}

void SceneVerifier::verifyDatasetValues() {
  const output::ManifestContent& content = dataset_.content();
  if (depth_ != VerificationDepth::kLabels || !content.complete || content.shard) return;
  std::vector<std::vector<std::string>> paths(content.writers.size());
  dataset_.forEachFileOf(std::nullopt, [&](const output::ListedFile& file) {
    if (file.writer < paths.size() && pathProblem(file, dataset_).empty()) {
      paths[file.writer].push_back(absoluteFrom(dataset_.folder(), file.path));
    }
  });
  for (std::size_t i = 0; i < paths.size(); ++i) {
    // What is wrong with a scene is wrong with the whole, too, and is reported already.
    if (labels_[i].format == nullptr || labels_[i].values == nullptr || !labels_[i].is_right) {
      continue;
    }
    const std::string origin = "writer '" + content.writers[i].name + "': ";
    try {
      formats::FoundFiles found = foundFiles(i, paths[i]);
      labels_[i].values->checkDataset(found);
      for (const std::string& problem : found.problems()) listener_.problem(origin + problem);
    } catch (const std::exception& error) {
      listener_.problem(origin + error.what());
    }
  }
}

}  // namespace synthetic_dataset::output
