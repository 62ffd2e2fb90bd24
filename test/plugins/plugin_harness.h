#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "output/writers/writer_host.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/hand_made.h"
#include "synthetic_dataset/parameters.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {

/// Loads one writer as users do, from the plugin library, and gives it hand-made scenes.
class PluginTest : public testing::Test {
 protected:
  explicit PluginTest(std::string type);

  static void SetUpTestSuite();

  /// Loads the writer with these parameters, under the name `w`.
  output::WriterHost& load(const Value::Map& parameters);

  [[nodiscard]] static Scene scene(std::int64_t index, std::vector<SceneObject> objects) {
    return handMadeScene(index, std::move(objects));
  }

  [[nodiscard]] static CameraModel camera() { return handMadeCamera(); }

  /// The same scene for a camera of another focal length [px].
  [[nodiscard]] static Scene zoomed(Scene scene, double focal_length);

  /// Tells the writer about a lidar, "top".
  void addLidar();

  /// Adds a cloud to the scene: two points of each object and one of the world.
  [[nodiscard]] static Scene withCloud(Scene scene);

  [[nodiscard]] static SceneObject object(const std::string& name) { return handMadeObject(name); }

  [[nodiscard]] static SceneObject seen(const std::string& name, const cv::Rect& pixels) {
    return handMadeObject(name, pixels);
  }

  /// The mask with all pixels of a rectangle added to it or removed from it.
  [[nodiscard]] static Mask painted(const Mask& mask, const cv::Rect& pixels, bool on);

  [[nodiscard]] static Keypoint keypoint(const std::optional<Eigen::Vector2d>& pixel, double depth,
                                         KeypointState state);

  [[nodiscard]] static PixelCounts counts(std::int64_t silhouette, std::int64_t in_image,
                                          std::int64_t visible);

  /// Two scenes of each of two cameras, the first in `train` and the second in `test`; the writer
  /// is told of them.
  /// @param scene  makes the one with an index
  std::vector<Scene> ofTwoCamerasAndSplits(const std::function<Scene(std::int64_t)>& scene);

  /// The files of a scene: path in the writer's folder to text, or to "<image>",
  /// "<silhouette NAME>", "<visible NAME>".
  [[nodiscard]] std::map<std::string, std::string> filesOf(const Scene& scene) const;

  /// The picture of a scene at a path in the writer's folder, as given by the writer; empty for
  /// none.
  [[nodiscard]] cv::Mat pictureOf(const Scene& scene, const std::string& path) const;

  /// Writes these scenes and finishes the dataset.
  void runAll(const std::vector<Scene>& scenes) const;

  [[nodiscard]] std::string folder() const { return (folder_ / "w/").string(); }

  test::TemporaryFolder folder_;
  DatasetInfo dataset_;  ///< given to the writer; has only the camera unless a test adds more
  Parameters parameters_{Value::Map{}};
  std::unique_ptr<output::WriterHost> host_;

 private:
  std::string type_;
};

}  // namespace synthetic_dataset
