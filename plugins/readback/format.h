#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/labelled_cloud.h"
#include "plugins/readback/written_scene.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::formats {

/// How a file's numbers represent depth.
struct DepthNumbers {
  double unit = 1.0;      ///< value of 1 [m]
  double rounding = 0.0;  ///< maximum error of a pixel's depth [m]
  double greatest = std::numeric_limits<double>::infinity();  ///< [m]
};

/// One of a scene's pictures that files store in a different form than Scene.
struct DecodedPicture {
  std::string name;           ///< as in Scene: "depth"; for clouds as in base/cloud_pictures.h
  cv::Mat pixels;             ///< in Scene's form, as far as the files tell
  std::string stored_as;      ///< the stored picture's name in the manifest; empty: no digest
  cv::Mat stored;             ///< the pixels of that digest, as in the files
  DepthNumbers numbers = {};  ///< how `stored` represents depth

  /// The files that contain only this picture.
  std::vector<std::filesystem::path> files;
};

/// What programs know about a format besides its writer. Each format's folder defines a namespace
/// of the same name with a function `Format format()`; CMake makes the list of all formats from
/// these.
struct Format {
  std::string type;  ///< of its writer, as in plugins.xml: "synthetic_dataset/Yolo"

  /// Whether labels can only be read once the files that describe the whole dataset exist.
  bool needs_dataset_files = false;

  /// Reads what a writer made of a scene, from its files only.
  /// @throws Error naming the file that is missing or violates the format
  LabelledPicture (*read)(const WrittenScene& scene) = nullptr;

  /// Reads pictures of a scene that its files store in another form; null if the format has none.
  /// @throws Error as `read` does
  std::vector<DecodedPicture> (*pictures)(const WrittenScene& scene, const CameraModel& camera,
                                          const DatasetInfo& dataset) = nullptr;

  /// Reads the lidar sweeps in a scene's files; null if the format has none.
  /// @throws Error as `read` does
  std::vector<LabelledCloud> (*clouds)(const WrittenScene& scene) = nullptr;
};

/// The name of each format's folder, by which users know it ("pascal_voc"), and its writer's type.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& formatNames();

/// The format of a type of writer; null if it is not one of this package's.
[[nodiscard]] const Format* formatOf(const std::string& writer_type);

}  // namespace synthetic_dataset::formats
