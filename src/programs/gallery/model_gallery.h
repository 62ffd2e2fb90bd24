#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "run/pictures/model_portrait.h"
#include "world/files/resource_finder.h"

namespace synthetic_dataset::programs {

/// What became of one model.
struct GalleryEntry {
  std::string name;  ///< its path below the gallery's folder
  run::ModelCounts counts;
  std::vector<std::string> notes;  ///< what was left out or replaced
  std::string error;               ///< why it could not be loaded; empty if it could
  cv::Mat picture;                 ///< CV_8UC3; none if there is nothing to see
};

/// The folders that `model://` and `package://` URIs of these models may mean: the given one, and
/// all that hold one of the models.
[[nodiscard]] std::vector<std::string> modelFolders(
    const std::filesystem::path& folder, const std::vector<std::filesystem::path>& models);

/// Loads one model, without what is missing of it, and takes its picture.
[[nodiscard]] GalleryEntry portrayModel(const std::filesystem::path& model, const std::string& name,
                                        const world::ResourceFinder& finder, const cv::Size& size);

/// Loads a world (or the file of one model), without what is missing of it, and takes a picture of
/// all of it, then one of each model alone. What was left out is with the model that lacks it, else
/// with the world.
[[nodiscard]] std::vector<GalleryEntry> portrayWorld(const std::filesystem::path& file,
                                                     const world::ResourceFinder& finder,
                                                     const cv::Size& size);

/// All pictures side by side, each with its name beneath, and with the error where there is one, or
/// with what the model lacks.
[[nodiscard]] cv::Mat contactSheet(const std::vector<GalleryEntry>& entries, const cv::Size& cell);

/// A line a model with its numbers, then what was left out or replaced, each remark once a model.
[[nodiscard]] std::string galleryTable(const std::vector<GalleryEntry>& entries);

}  // namespace synthetic_dataset::programs
