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

/// A scene's `image`, `depth`, `normals` and `optical_flow`, as far as they can be recovered from
/// the dataset's files.
class ScenePictures {
 public:
  /// @param facts  with a camera model; must outlive this
  explicit ScenePictures(const SceneFacts& facts) : facts_(facts) {}

  /// What to fill unknown pictures with. Whatever depends on them differs between the two.
  enum class Filling { kNothing, kSomething };

  /// Gives a scene its pictures.
  void give(Scene& scene, Filling filling) const;

  /// Gives a scene made-up clouds, since no file holds a complete one: for those in files, only
  /// digests and the number of points on each object are known.
  /// @param dataset  with its lidars
  void giveClouds(Scene& scene, const DatasetInfo& dataset, Filling filling) const;

  /// The name of the scene's picture that a writer passes on unchanged; nothing for other pixels.
  [[nodiscard]] static std::optional<std::string> nameOf(const cv::Mat& pixels, const Scene& scene);

  [[nodiscard]] bool isKnown(const std::string& picture) const { return known_.count(picture) > 0; }

  /// Takes a picture from a file that holds it unchanged, or as JPEG.
  /// @return  what is wrong with it; empty if nothing
  /// @throws Error if it cannot be decoded
  [[nodiscard]] std::string take(const std::string& picture, const std::string& file);

  /// Takes a picture that a file holds in another form.
  [[nodiscard]] std::string take(const formats::DecodedPicture& picture);

 private:
  [[nodiscard]] const PictureFacts* factsOf(const std::string& picture) const;
  [[nodiscard]] std::string problemOf(const std::string& picture, const std::string& digest) const;

  const SceneFacts& facts_;
  std::map<std::string, cv::Mat> known_;
};

}  // namespace synthetic_dataset::output
