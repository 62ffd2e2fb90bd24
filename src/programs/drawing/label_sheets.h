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
  /// @param folder  of the run's manifest
  /// @param writer  the name of the one that is drawn; without it, a panel for each
  /// @param warn  gets each reason why a writer's panel of a scene is left out, once
  /// @throws Error when there is no dataset, or it has no such writer
  LabelSheets(const std::string& folder, const std::optional<std::string>& writer,
              std::function<void(const std::string&)> warn);

  [[nodiscard]] const output::WrittenDataset& dataset() const { return dataset_; }

  /// A panel for each writer that made a picture of the scene; nothing where none did.
  /// @throws Error when there is no such scene, or the one writer's files cannot be read
  [[nodiscard]] std::optional<cv::Mat> sheet(std::int64_t scene);

  /// The same with a panel for each writer that makes pictures, so that all sheets are alike.
  [[nodiscard]] std::optional<cv::Mat> regularSheet(std::int64_t scene);

  /// The scene's image with the labels of the one writer, or of the first that can be read, without
  /// clouds; nothing where there is no image.
  [[nodiscard]] std::optional<cv::Mat> labelledImage(std::int64_t scene);

  /// A lidar's sweep of a scene.
  struct Sweep {
    std::string writer;  ///< whose files it is read from
    formats::LabelledCloud cloud;
  };

  /// The sweeps of a scene's lidars, each once: from the writer whose files say most of it.
  [[nodiscard]] std::vector<Sweep> sweeps(std::int64_t scene);

  /// A sweep as sheets have it.
  [[nodiscard]] cv::Mat drawn(const Sweep& sweep) const;

  /// The scene's image without labels, as the first writer has it that can be read; nothing where
  /// none did.
  [[nodiscard]] std::optional<cv::Mat> image(std::int64_t scene) const;

  /// The writers that are drawn: "coco, yolo"
  [[nodiscard]] std::string writerNames() const;

 private:
  struct Panel {
    std::string caption;
    cv::Mat picture;  ///< empty where the writer made none of the scene
  };

  [[nodiscard]] std::vector<Panel> panelsOf(std::int64_t scene);
  [[nodiscard]] formats::WrittenScene written(const output::WrittenWriter& writer,
                                              std::int64_t scene) const;
  [[nodiscard]] formats::LabelledPicture labelsOf(const output::WrittenWriter& writer,
                                                  std::int64_t scene) const;
  [[nodiscard]] std::vector<formats::LabelledCloud> cloudsOf(const output::WrittenWriter& writer,
                                                             std::int64_t scene) const;
  [[nodiscard]] cv::Mat pictureOf(const output::WrittenWriter& writer, std::int64_t scene) const;

  /// Does what reads a writer's files, of which a scene may be without where there are others.
  void reading(const output::WrittenWriter& writer, const std::function<void()>& read);
  [[nodiscard]] static std::optional<cv::Mat> sheetOf(const std::vector<Panel>& panels);

  output::WrittenDataset dataset_;
  bool is_one_ = false;  ///< whether one writer was asked for
  std::vector<output::WrittenWriter> writers_;
  std::vector<std::string> classes_;          ///< of objects, in the order of their ids
  std::map<std::string, std::int64_t> rays_;  ///< of a sweep, by the lidar's name
  std::shared_ptr<formats::KeptFiles> kept_ = std::make_shared<formats::KeptFiles>();
  std::function<void(const std::string&)> warn_;
  std::set<std::string> warned_;
};

}  // namespace synthetic_dataset::programs
