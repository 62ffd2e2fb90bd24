#pragma once

#include <map>
#include <optional>
#include <string>

#include <opencv2/core/mat.hpp>

#include "output/manifest/picture_facts.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::output {

/// A scene's `image`, `depth`, `normals` and `optical_flow`, as far as the dataset's files show
/// them.
class ScenePictures {
 public:
  /// @param facts  with a camera model; outlives this
  explicit ScenePictures(const SceneFacts& facts) : facts_(facts) {}

  /// What a picture holds that is not known. What depends on it differs between the two.
  enum class Filling { kNothing, kSomething };

  /// Gives a scene its pictures.
  void give(Scene& scene, Filling filling) const;

  /// Gives a scene clouds, of which no file holds all: of those that files hold, digests are known,
  /// and how many points each object has.
  /// @param dataset  with its lidars
  void giveClouds(Scene& scene, const DatasetInfo& dataset, Filling filling) const;

  /// The name of a scene's picture that a writer hands on as it is; nothing for other pixels.
  [[nodiscard]] static std::optional<std::string> nameOf(const cv::Mat& pixels, const Scene& scene);

  [[nodiscard]] bool isKnown(const std::string& picture) const { return known_.count(picture) > 0; }

  /// Takes a picture from a file that holds it as it is, or as JPEG.
  /// @return  what is wrong with it; empty: nothing
  /// @throws Error when it cannot be decoded
  [[nodiscard]] std::string take(const std::string& picture, const std::string& file);

  /// The same of one that files hold in another form.
  [[nodiscard]] std::string take(const formats::DecodedPicture& picture);

 private:
  [[nodiscard]] const PictureFacts* factsOf(const std::string& picture) const;
  [[nodiscard]] std::string problemOf(const std::string& picture, const std::string& digest) const;

  const SceneFacts& facts_;
  std::map<std::string, cv::Mat> known_;
};

}  // namespace synthetic_dataset::output
