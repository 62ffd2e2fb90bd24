#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "output/written_dataset.h"
#include "plugins/readback/drawn_label.h"
#include "plugins/readback/kept_files.h"
#include "plugins/readback/labelled_cloud.h"
#include "plugins/readback/written_scene.h"

namespace synthetic_dataset::programs {

/// Draws scenes of a dataset with the labels that the files of its formats contain.
class LabelSheets {
 public:
  /// @param folder  the one that contains the run's manifest
  /// @param writer  the name of the only writer to draw; without it, each writer has a panel
  /// @param warn  receives each reason why a writer's panel of a scene is left out, once
  /// @throws Error when there is no dataset, or it has no such writer
  LabelSheets(const std::string& folder, const std::optional<std::string>& writer,
              std::function<void(const std::string&)> warn);

  [[nodiscard]] const output::WrittenDataset& dataset() const { return dataset_; }

  /// A panel for each writer that made a picture of the scene; nothing if none did.
  /// @throws Error when there is no such scene, or the one writer's files cannot be read
  [[nodiscard]] std::optional<cv::Mat> sheet(std::int64_t scene);

  /// Like sheet(), but with a panel for every writer that makes pictures, so that all sheets have
  /// the same layout.
  [[nodiscard]] std::optional<cv::Mat> regularSheet(std::int64_t scene);

  /// The scene's image with the labels of the one writer, or of the first that can be read, without
  /// clouds; nothing if there is no image.
  [[nodiscard]] std::optional<cv::Mat> labelledImage(std::int64_t scene);

  /// A lidar's sweep of a scene.
  struct Sweep {
    std::string writer;  ///< the writer whose files it is read from
    formats::LabelledCloud cloud;
  };

  /// One sweep for each lidar of a scene, from the writer whose files contain most about it.
  [[nodiscard]] std::vector<Sweep> sweeps(std::int64_t scene);

  /// Draws a sweep in the form used on sheets.
  [[nodiscard]] cv::Mat drawn(const Sweep& sweep) const;

  /// The scene's image without labels, from the first writer with one that can be read; nothing if
  /// there is none.
  [[nodiscard]] std::optional<cv::Mat> image(std::int64_t scene) const;

  /// The writers that are drawn: "coco, yolo"
  [[nodiscard]] std::string writerNames() const;

 private:
  struct Panel {
    std::string caption;
    cv::Mat picture;  ///< empty if the writer made none of the scene
  };

  [[nodiscard]] std::vector<Panel> panelsOf(std::int64_t scene);
  [[nodiscard]] formats::WrittenScene written(const output::WrittenWriter& writer,
                                              std::int64_t scene) const;
  [[nodiscard]] formats::LabelledPicture labelsOf(const output::WrittenWriter& writer,
                                                  std::int64_t scene) const;
  [[nodiscard]] std::vector<formats::LabelledCloud> cloudsOf(const output::WrittenWriter& writer,
                                                             std::int64_t scene) const;
  [[nodiscard]] cv::Mat pictureOf(const output::WrittenWriter& writer, std::int64_t scene) const;

  /// Calls a function that reads a writer's files. If it fails, warns and goes on, unless this
  /// writer was asked for.
  void reading(const output::WrittenWriter& writer, const std::function<void()>& read);
  [[nodiscard]] static std::optional<cv::Mat> sheetOf(const std::vector<Panel>& panels);

  output::WrittenDataset dataset_;
  bool has_single_writer_ = false;  ///< whether one writer was asked for
  std::vector<output::WrittenWriter> writers_;
  std::vector<std::string> classes_;          ///< of objects, in the order of their ids
  std::map<std::string, std::int64_t> rays_;  ///< per sweep, by the lidar's name
  std::shared_ptr<formats::KeptFiles> kept_ = std::make_shared<formats::KeptFiles>();
  std::function<void(const std::string&)> warn_;
  std::set<std::string> warned_;
};

}  // namespace synthetic_dataset::programs
