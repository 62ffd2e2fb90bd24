#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "run/pictures/model_portrait.h"
#include "world/files/resource_finder.h"

namespace synthetic_dataset::programs {

/// The result for one model.
struct GalleryEntry {
  std::string name;  ///< its path below the gallery's folder
  run::ModelCounts counts;
  std::vector<std::string> notes;  ///< what was left out or replaced
  std::string error;               ///< why it could not be loaded; empty if it could
  cv::Mat picture;                 ///< CV_8UC3; empty if there is nothing to see
};

/// The folders to which `model://` and `package://` URIs of these models may refer: the given one,
/// and all folders inside it that contain one of the models.
[[nodiscard]] std::vector<std::string> modelFolders(
    const std::filesystem::path& folder, const std::vector<std::filesystem::path>& models);

/// Loads one model, without the assets that are missing, and draws its picture.
[[nodiscard]] GalleryEntry portrayModel(const std::filesystem::path& model, const std::string& name,
                                        const world::ResourceFinder& finder, const cv::Size& size);

/// Loads a world (or the file of one model), without the assets that are missing, and draws a
/// picture of all of it, then one of each model by itself. What was left out is noted for the model
/// that lacks it, else for the world.
[[nodiscard]] std::vector<GalleryEntry> portrayWorld(const std::filesystem::path& file,
                                                     const world::ResourceFinder& finder,
                                                     const cv::Size& size);

/// All pictures side by side, each with its name beneath, and with the error, if there is one, or
/// with what the model lacks.
[[nodiscard]] cv::Mat contactSheet(const std::vector<GalleryEntry>& entries, const cv::Size& cell);

/// One line per model with its counts, then what was left out or replaced, each remark once per
/// model.
[[nodiscard]] std::string galleryTable(const std::vector<GalleryEntry>& entries);

}  // namespace synthetic_dataset::programs
