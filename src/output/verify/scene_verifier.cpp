#include "output/verify/scene_verifier.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

#include <opencv2/imgcodecs.hpp>

#include "output/manifest/manifest_paths.h"
#include "output/verify/expected_files.h"
#include "output/verify/label_checks.h"
#include "plugins/readback/files.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {
namespace {

/// Whether a file is a picture, judging by its name.
bool isPicture(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg" ||
         extension == ".tiff" || extension == ".tif";
}

std::string text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// Same as Scene::name: with the camera's folder if there are several.
std::string sceneName(const SceneFacts& scene, std::size_t camera_count) {
  return (camera_count > 1 ? scene.camera + "/" : "") + sceneNumber(scene.instant);
}

}  // namespace

SceneVerifier::SceneVerifier(const WrittenDataset& dataset, VerificationDepth depth,
                             WriterLoader* loader, VerificationListener& listener,
                             VerificationCounts& counts)
    : dataset_(dataset),
      depth_(depth),
      listener_(listener),
      counts_(counts),
      true_(dataset.content().run),
      labels_(dataset.content().writers.size()) {
  if (depth_ != VerificationDepth::kLabels) return;
  const ManifestContent& content = dataset.content();
  const bool has_dataset_files = content.complete && !content.shard;
  std::string unread;
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const StoreWriter& writer = content.writers[i];
    Labels& labels = labels_[i];
    labels.format = formats::formatOf(writer.type);
    labels.can_be_read =
        labels.format != nullptr && (has_dataset_files || !labels.format->needs_dataset_files);
    if (labels.format == nullptr || labels.can_be_read) continue;
    unread += (unread.empty() ? "'" : ", '") + writer.name + "'";
  }
  if (!content.is_current) {
    remark(
        "it is from release 0.1.0, which does not record what labels should be: the checks are "
        "that files are as they were written, and that labels can be read");
  } else if (loader != nullptr) {
    loadWriters(*loader);
  }
  if (unread.empty() || content.scene_count == 0) return;
  remark("the labels of " + unread + " are checked as stored in the manifest, and not counted: " +
         "their files are those of a whole, complete dataset");
}

void SceneVerifier::loadWriters(WriterLoader& loader) {
  const ManifestContent& content = dataset_.content();
  // An invalid camera is reported with the manifest's rows.
  const bool has_cameras =
      std::all_of(content.run.cameras.begin(), content.run.cameras.end(),
                  [](const RunDescription::Camera& each) { return each.model.has_value(); });
  for (std::size_t i = 0; has_cameras && i < labels_.size(); ++i) {
    const StoreWriter& writer = content.writers[i];
    Parameters parameters(dataset_.writers()[i].settings, writer.name);
    try {
      auto ready = std::make_unique<ReadyWriter>(
          loader, WriterOptions{writer.name, writer.type, writer.output_folder, parameters},
          true_.dataset());
      if (!parameters.errors().empty()) throw Error(parameters.errors().front());
      labels_[i].writer = std::move(ready);
    } catch (const std::exception& error) {
      remark("the labels of '" + writer.name +
             "' are not checked, as its writer cannot be run: " + error.what());
    }
  }
}

void SceneVerifier::remark(const std::string& what) {
  listener_.remark("'" + dataset_.manifest() + "': " + what);
}

void SceneVerifier::report(std::size_t writer, const std::string& problem) {
  labels_[writer].is_right = false;
  listener_.problem(problem);
}

std::string SceneVerifier::originOf(const SceneFacts& scene, std::size_t writer) const {
  return "scene " + std::to_string(scene.index) + ", writer '" +
         dataset_.content().writers[writer].name + "': ";
}

void SceneVerifier::verifyDatasetFiles() {
  // While the run is unfinished, they may be announced but not exist yet.
  if (!dataset_.content().complete) return;
  dataset_.forEachFileOf(std::nullopt, [&](const ListedFile& file) {
    WrittenFiles files;
    verifyFile(file, files);
    if (files.are_whole || depth_ != VerificationDepth::kLabels) return;
    Labels& labels = labels_.at(file.writer);
    labels.is_right = false;
    if (!labels.can_be_read || !labels.format->needs_dataset_files) return;
    labels.can_be_read = false;
    remark("the labels of '" + dataset_.content().writers[file.writer].name +
           "' are not checked: a file that they need is not as it was written");
  });
}

void SceneVerifier::verifyFile(const ListedFile& file, WrittenFiles& of_writer) {
  ++counts_.files;
  const std::string path_problem = pathProblem(file, dataset_);
  if (!path_problem.empty()) {
    listener_.problem("'" + dataset_.manifest() + "': the listed path '" + file.path + "' " +
                      path_problem);
    of_writer.are_readable = of_writer.are_whole = false;
    return;
  }
  const std::string& folder = dataset_.folder();
  const std::string path = absoluteFrom(folder, file.path);
  const FileFinding finding =
      checkFile(path, file.linked_to ? absoluteFrom(folder, *file.linked_to) : "", file,
                depth_ == VerificationDepth::kSizes ? FileCheck::kSize : FileCheck::kContent);
  if (!finding.problem.empty()) {
    listener_.problem("'" + path + "' " + finding.problem);
    of_writer.are_whole = false;
  }
  of_writer.are_readable = of_writer.are_readable && finding.is_readable;
  of_writer.listed.push_back(file);
  of_writer.paths.push_back(path);
}

void SceneVerifier::verifyScene(const SceneFacts& scene) {
  ++counts_.scenes;
  const auto& writers = dataset_.content().writers;
  std::vector<WrittenFiles> files(writers.size());
  dataset_.forEachFileOf(scene.index, [&](const ListedFile& file) {
    if (file.writer < files.size()) verifyFile(file, files[file.writer]);
  });
  if (depth_ != VerificationDepth::kLabels || !isSound(scene)) return;
  std::vector<std::size_t> compared;
  for (std::size_t i = 0; i < writers.size(); ++i) {
    if (!files[i].are_whole) labels_[i].is_right = false;
    if (!files[i].are_readable) continue;
    try {
      const bool have_its_size = verifyPictures(writers[i], files[i], scene);
      // Formats with a folder for each object write no files for a scene without labels.
      if (labels_[i].can_be_read && !files[i].paths.empty()) {
        const formats::LabelledPicture picture =
            labels_[i].format->read(writtenScene(scene, i, files[i]));
        counts_.labels += static_cast<std::int64_t>(picture.labels.size());
      }
      const bool is_known = labels_[i].writer != nullptr && files[i].are_whole;
      if (is_known && have_its_size) compared.push_back(i);
    } catch (const std::exception& error) {
      report(i, originOf(scene, i) + error.what());
    }
  }
  verifyValues(scene, files, compared);
}

/// Whether a scene's rows fit the run's; reports the first scene that does not.
bool SceneVerifier::isSound(const SceneFacts& scene) {
  if (!dataset_.content().is_current) return true;
  const std::string unknown = true_.unknownIn(scene);
  if (unknown.empty()) return true;
  if (!std::exchange(has_unsound_scenes_, true)) {
    listener_.problem(
        "'" + dataset_.manifest() + "': the labels of scene " + std::to_string(scene.index) +
        ", and of others like it, cannot be checked: the run does not know " + unknown);
  }
  return false;
}

/// @return  whether all pictures have their camera's size
bool SceneVerifier::verifyPictures(const StoreWriter& writer, const WrittenFiles& files,
                                   const SceneFacts& scene) {
  const cv::Size size(scene.width, scene.height);
  const bool is_ours = writer.type.rfind("synthetic_dataset/", 0) == 0;
  bool have_its_size = true;
  for (std::size_t i = 0; i < files.paths.size(); ++i) {
    if (!isPicture(files.paths[i]) || files.listed[i].linked_to) continue;
    const cv::Mat picture = formats::readPicture(files.paths[i], cv::IMREAD_UNCHANGED);
    if (!is_ours || picture.size() == size) continue;
    have_its_size = false;
    listener_.problem("'" + files.paths[i] + "' is a picture of " + text(picture.size()) +
                      " pixels; it should be of its camera's " + text(size));
  }
  return have_its_size;
}

formats::WrittenScene SceneVerifier::writtenScene(const SceneFacts& scene, std::size_t writer,
                                                  const WrittenFiles& files) const {
  const std::vector<RunDescription::Camera>& cameras = dataset_.content().run.cameras;
  const auto camera = std::find_if(cameras.begin(), cameras.end(),
                                   [&](const auto& each) { return each.name == scene.camera; });
  if (camera == cameras.end()) throw Error("the manifest has no camera '" + scene.camera + "'");
  return {dataset_.content().writers[writer].output_folder,
          sceneName(scene, cameras.size()),
          static_cast<std::size_t>(camera - cameras.begin()),
          scene.stamp,
          {files.paths.begin(), files.paths.end()},
          kept_,
          dataset_.writers()[writer].settings};
}

void SceneVerifier::verifyValues(const SceneFacts& facts, const std::vector<WrittenFiles>& files,
                                 const std::vector<std::size_t>& writers) {
  const auto guarded = [&](const auto& work) {
    for (const std::size_t writer : writers) {
      try {
        work(writer);
      } catch (const std::exception& error) {
        report(writer, originOf(facts, writer) + error.what());
      }
    }
  };
  if (!facts.camera_model) {
    guarded([](std::size_t /*writer*/) {
      throw Error("the manifest does not say with which camera it was made");
    });
    return;
  }
  Scene scene = true_.scene(facts);
  ScenePictures pictures(facts);
  pictures.giveClouds(scene, true_.dataset(), ScenePictures::Filling::kNothing);
  pictures.give(scene, ScenePictures::Filling::kNothing);
  std::vector<FoundScene> found(labels_.size());
  guarded([&](std::size_t writer) {
    found[writer] = foundScene(facts, writer, files[writer]);
    takePictures(facts, scene, writer, files[writer], pictures, found[writer]);
  });
  pictures.give(scene, ScenePictures::Filling::kNothing);
  std::optional<Scene> other;
  guarded([&](std::size_t writer) {
    RewrittenScene right;
    labels_[writer].writer->writeScene(scene, writer, right.result);
    if (dependsOnUnknown(writer, pictures)) {
      if (!other) {
        pictures.give(other.emplace(scene), ScenePictures::Filling::kSomething);
        pictures.giveClouds(*other, true_.dataset(), ScenePictures::Filling::kSomething);
      }
      right.other.emplace();
      labels_[writer].writer->writeScene(*other, writer, *right.other);
    }
    compare(facts, writer, files[writer], found[writer], right);
  });
}

FoundScene SceneVerifier::foundScene(const SceneFacts& facts, std::size_t writer,
                                     const WrittenFiles& files) const {
  FoundScene found;
  const StoreWriter& of = dataset_.content().writers[writer];
  found.folder = of.output_folder;
  found.files = {files.paths.begin(), files.paths.end()};
  found.records = dataset_.recordsOf(writer, facts.index);
  const std::string of_writer = "writer '" + of.name + "': ";
  for (const Warning& each : facts.warnings) {
    if (each.kind.rfind(of_writer, 0) == 0) found.warnings.push_back(each.kind);
  }
  return found;
}

/// Finds the files that hold the scene's own pictures, by what the writer passes on.
void SceneVerifier::takePictures(const SceneFacts& facts, const Scene& scene, std::size_t writer,
                                 const WrittenFiles& files, ScenePictures& pictures,
                                 FoundScene& found) {
  const auto tell = [&](const std::string& path, const std::string& problem) {
    found.checked.insert(path);
    if (problem.empty()) return;
    report(writer, originOf(facts, writer) + pathBelow(found.folder, path) + ": " + problem);
  };
  ReadyWriter::SceneResult written;
  labels_[writer].writer->writeScene(scene, writer, written);
  for (const OutputFile& each : written.files.files) {
    const auto picture = each.palette.empty() ? ScenePictures::nameOf(each.pixels, scene)
                                              : std::optional<std::string>();
    if (picture && found.files.count(each.path) > 0) {
      tell(each.path, pictures.take(*picture, each.path));
    }
  }
  const formats::Format* format = labels_[writer].format;
  if (format == nullptr || format->pictures == nullptr) return;
  for (const formats::DecodedPicture& each :
       format->pictures(writtenScene(facts, writer, files), scene.camera, true_.dataset())) {
    const std::string problem = pictures.take(each);
    for (const std::filesystem::path& file : each.files) {
      tell(file.string(), &file == &each.files.front() ? problem : "");
    }
  }
}

bool SceneVerifier::dependsOnUnknown(std::size_t writer, const ScenePictures& pictures) const {
  const Requirements& needs = labels_[writer].writer->requirements();
  return !pictures.isKnown("image") || (needs.depth && !pictures.isKnown("depth")) ||
         (needs.normals && !pictures.isKnown("normals")) ||
         (needs.optical_flow && !pictures.isKnown("optical_flow")) || needs.clouds;
}

void SceneVerifier::compare(const SceneFacts& facts, std::size_t writer, const WrittenFiles& files,
                            const FoundScene& found, const RewrittenScene& right) {
  const SceneDifferences differences = compareScene(found, right);
  Labels& labels = labels_[writer];
  if (!differences.unknown.empty() && !std::exchange(labels.has_unknown_files, true)) {
    remark("'" + differences.unknown + "' of '" + dataset_.content().writers[writer].name +
           "', and files like it, are checked only by their sizes and SHA-256: they are made of "
           "pictures or clouds that no file of the dataset holds unchanged");
  }
  if (differences.values.empty() && differences.pictures.empty()) return;
  const std::string origin = originOf(facts, writer);
  const bool is_drawn = right.drawn_quality.has_value();
  std::vector<std::string> lines;
  // Do not report again what was found before the scene was rendered again.
  const auto append = [&](const std::vector<std::string>& more, bool are_said) {
    for (const std::string& line : more) {
      const bool is_new = is_drawn ? labels.known.count(origin + line) == 0
                                   : labels.known.insert(origin + line).second;
      if (is_new && are_said) lines.push_back(line);
    }
  };
  append(wrongLabels(facts, writer, files, right.result.files), true);
  const bool have_labels = !lines.empty();
  append(differences.values.lines(), !have_labels);
  append(differences.pictures.lines(), !have_labels || is_drawn);
  for (const std::string& line : lines) {
    report(writer, (is_drawn ? kDrawnAgain : "") + origin + line);
  }
}

std::vector<std::string> SceneVerifier::wrongLabels(const SceneFacts& facts, std::size_t writer,
                                                    const WrittenFiles& files,
                                                    const SceneFiles& right) const {
  const Labels& labels = labels_[writer];
  if (!labels.can_be_read) return {};
  try {
    ExpectedFiles place(*labels.writer);
    place.addScene(right);
    if (labels.format->needs_dataset_files) {
      place.addDataset(RecordsOfScene(facts.index, right.records));
    }
    const formats::WrittenScene found = writtenScene(facts, writer, files);
    formats::WrittenScene of_right = found;
    of_right.folder = place.folder();
    of_right.files = place.filesOf(right);
    of_right.kept = std::make_shared<formats::KeptFiles>();
    const auto read = [&](const formats::WrittenScene& scene) {
      return scene.files.empty() ? formats::LabelledPicture() : labels.format->read(scene);
    };
    return labelProblems(read(found), read(of_right), facts, dataset_.content().run);
  } catch (const std::exception&) {
    return {};  // the differing values are then reported as they are in the files
  }
}

}  // namespace synthetic_dataset::output
