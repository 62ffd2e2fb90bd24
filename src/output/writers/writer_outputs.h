#pragma once

#include <set>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset::output {

/// The paths in its folder that a writer has requested so far.
class ClaimedPaths {
 public:
  /// @param folder  absolute, ending in `/`
  explicit ClaimedPaths(std::string folder);

  /// @returns the absolute path
  /// @throws Error if the path leads out of the folder or was claimed before
  [[nodiscard]] std::string claim(const std::string& path);

  /// The absolute path, without claiming it.
  [[nodiscard]] std::string absolute(const std::string& path) const;

 private:
  std::string folder_;
  std::set<std::string> claimed_;
};

/// Gathers everything that one writer outputs for one scene.
class GatheringSceneOutput : public SceneOutput {
 public:
  /// @param writer  its index in the store's writers
  /// @param files, warnings  where to add; must outlive this
  GatheringSceneOutput(std::size_t writer, const WriterParameters& parameters,
                       output::SceneFiles& files, std::vector<std::string>& warnings);

  void addImage(const std::string& path, const cv::Mat& image) override;
  void addMask(const std::string& path, const Mask& mask) override;
  void addIndexedImage(const std::string& path, const cv::Mat& indices,
                       const std::vector<cv::Vec3b>& palette) override;
  void addText(const std::string& path, std::string text) override;
  void addRecord(const std::string& channel, std::string record) override;
  void addWarning(const std::string& kind) override;

 private:
  std::size_t writer_;
  std::string name_;
  ClaimedPaths paths_;
  output::SceneFiles& files_;
  std::vector<std::string>& warnings_;
};

/// Passes a writer's files of the dataset as a whole on to the store.
class StoringDatasetOutput : public DatasetOutput {
 public:
  /// @param writer  its index in the store's writers
  /// @param parameters, store  must outlive this
  StoringDatasetOutput(std::size_t writer, const WriterParameters& parameters,
                       output::DatasetStore& store);

  void addFile(const std::string& path, const Content& content) override;
  void addFileAtParameter(const FileParameter& file, const Content& content) override;
  void addFileByName(const std::string& path,
                     const std::function<void(const std::string& file)>& write) override;
  void addLink(const std::string& path, const std::string& scene_file) override;
  [[nodiscard]] std::string readFile(const std::string& scene_file) const override;

 private:
  std::size_t writer_;
  const WriterParameters& parameters_;
  ClaimedPaths paths_;
  output::DatasetStore& store_;
};

}  // namespace synthetic_dataset::output
