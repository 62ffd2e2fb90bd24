#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core/mat.hpp>

#include "plugins/readback/differences.h"
#include "plugins/readback/kept_files.h"
#include "synthetic_dataset/mask.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::formats {

/// What is true of a scene, as the run's own core has written it into the manifest.
struct TrueScene {
  explicit TrueScene(const CameraModel& camera) : scene(camera) {}

  /// All that a writer is given but for its pictures: `image`, `depth`, `normals`, `optical_flow`
  /// and `class_map` are not known.
  Scene scene;

  /// SHA-256 of the pixels of those, by name; of "image.jpg" that of the JPEG file's bytes; of
  /// "normals.colours" that of normals as colours of 8 bits; of "depth.0.001" and "depth.0.0001"
  /// that of depth in whole numbers of this many metres, of 16 bits.
  std::map<std::string, std::string> digests;

  /// Of the depth image, for each square of kDepthCell pixels, row by row from the top left: the
  /// sum, the least and the greatest [m].
  std::vector<float> depth_cells;

  std::set<std::string> warned_of;  ///< kinds of warnings of the writer that is checked

  static constexpr int kDepthCell = 32;  ///< [px]
};

/// The files that a writer has made of a scene, or of the dataset as a whole, while they are held
/// against what they should be. Files that nobody has asked for in the end are a fault.
class FoundFiles {
 public:
  using DigestOfPixels = std::function<std::string(const cv::Mat&)>;
  using DigestOfBytes = std::function<std::string(const std::string&)>;

  /// @param folder  the writer's
  /// @param names  of the files, below that folder; those elsewhere are absolute
  FoundFiles(std::filesystem::path folder, const std::vector<std::string>& names,
             DigestOfPixels digest_of_pixels, DigestOfBytes digest_of_bytes,
             std::shared_ptr<KeptFiles> kept);

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] KeptFiles& kept() const { return *kept_; }

  /// The path of a file that should be there; nothing, and a fault, where it is not.
  std::optional<std::filesystem::path> take(const std::string& name);

  void compareJson(const std::string& name, const nlohmann::json& right);
  void compareText(const std::string& name, const std::string& right);

  /// Pixel by pixel.
  void comparePicture(const std::string& name, const cv::Mat& right);
  void compareMask(const std::string& name, const Mask& right);

  /// With one of the scene's own pictures: "image", "depth", ...
  void compareWithScene(const std::string& name, const TrueScene& scene,
                        const std::string& picture = "image");

  /// The same of pixels that were read from files.
  void comparePixels(const std::string& name, const cv::Mat& found, const TrueScene& scene,
                     const std::string& picture);

  /// A file that should have the same bytes as one of a scene.
  void compareBytes(const std::string& name, const std::filesystem::path& other);

  [[nodiscard]] Differences& differences() { return differences_; }

  /// All that is wrong, with files that should not be there.
  [[nodiscard]] std::vector<std::string> problems() const;

 private:
  void compareDigest(const std::string& name, const std::string& found, const TrueScene& scene,
                     const std::string& picture);

  std::filesystem::path folder_;
  std::set<std::string> left_;  ///< names of files that were not asked for yet
  DigestOfPixels digest_of_pixels_;
  DigestOfBytes digest_of_bytes_;
  std::shared_ptr<KeptFiles> kept_;
  Differences differences_;
};

/// Holds all that a format's files hold against the truth.
class ValueCheck {
 public:
  ValueCheck() = default;
  ValueCheck(const ValueCheck&) = delete;
  ValueCheck& operator=(const ValueCheck&) = delete;
  virtual ~ValueCheck();

  /// The files of one scene; called for each in their order.
  virtual void checkScene(const TrueScene& scene, FoundFiles& files) = 0;

  /// The files of the dataset as a whole, after all scenes.
  virtual void checkDataset(FoundFiles& files) = 0;
};

}  // namespace synthetic_dataset::formats
