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

/// What numbers of a file can say of a depth.
struct DepthNumbers {
  double unit = 1.0;      ///< what 1 is [m]
  double rounding = 0.0;  ///< how far a pixel's depth may be off [m]
  double greatest = std::numeric_limits<double>::infinity();  ///< [m]
};

/// One of a scene's pictures that files hold in another form than it has in Scene.
struct DecodedPicture {
  std::string name;       ///< in Scene: "depth"; of clouds as base/cloud_pictures.h has them
  cv::Mat pixels;         ///< as Scene has them, as far as the files say
  std::string stored_as;  ///< the manifest's name of what is stored; empty: it has no digest of it
  cv::Mat stored;         ///< pixels of that digest, as the files have them
  DepthNumbers numbers = {};  ///< what `stored` can say of a depth

  /// The files that hold this picture and nothing else.
  std::vector<std::filesystem::path> files;
};

/// What programs know of a format beside its writer. Each folder of a format has a namespace of its
/// name with a function `Format format()` in it, from which CMake makes the list of all.
struct Format {
  std::string type;  ///< of its writer, as plugins.xml has it: "synthetic_dataset/Yolo"

  /// Whether labels can only be read when the files of the dataset as a whole are there.
  bool needs_dataset_files = false;

  /// Reads what a writer made of a scene from its files alone.
  /// @throws Error naming the file that is missing or not as the format has it
  LabelledPicture (*read)(const WrittenScene& scene) = nullptr;

  /// Pictures of a scene that its files hold in another form; null where the format has none.
  /// @throws Error as `read` does
  std::vector<DecodedPicture> (*pictures)(const WrittenScene& scene, const CameraModel& camera,
                                          const DatasetInfo& dataset) = nullptr;

  /// The sweeps of lidars that a scene's files hold; null where the format has none.
  /// @throws Error as `read` does
  std::vector<LabelledCloud> (*clouds)(const WrittenScene& scene) = nullptr;
};

/// The name of each format's folder, under which users know it ("pascal_voc"), and its writer's
/// type.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& formatNames();

/// The format of a type of writer; null where it is none of this package's.
[[nodiscard]] const Format* formatOf(const std::string& writer_type);

}  // namespace synthetic_dataset::formats
