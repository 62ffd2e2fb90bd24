#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "world/description.h"
#include "world/files/resource_finder.h"

namespace synthetic_dataset::world {

/// What a picture's alpha channel says: only some materials mean it as holes.
enum class AlphaMeaning { kIgnored, kOpacity };

/// What is made of a picture's channels.
enum class PictureContent {
  kColour,       ///< as they are
  kRed,          ///< the red one in place of all three: a number for each place
  kInvertedRed,  ///< 1 minus the red one in place of all three: glossiness as roughness
  /// A normal map; of a grey picture, whose values are heights, the normal map that belongs to
  /// them. Mesh files name both kinds alike.
  kNormalsOrHeights,
  kAlphaFromGrey,  ///< an opacity picture: its grey as alpha, its colour white
};

/// A picture that a mesh file carries within itself.
struct EmbeddedPicture {
  std::string name;                 ///< for messages
  std::vector<std::uint8_t> bytes;  ///< a whole picture file
};

/// How a mesh file or a material names its picture.
struct TextureReference {
  std::string uri;
  std::filesystem::path folder;  ///< of the file that names it
  std::shared_ptr<const EmbeddedPicture> embedded;
  AlphaMeaning alpha = AlphaMeaning::kIgnored;
  PictureContent content = PictureContent::kColour;
  std::vector<std::filesystem::path> more_folders;  ///< in which its file name is looked for, too
};

/// Decodes each picture once, however many materials name it.
class TextureLoader {
 public:
  explicit TextureLoader(const ResourceFinder& finder) : finder_(finder) {}
  explicit TextureLoader(ResourceFinder&&) = delete;  // it has to outlive this

  /// Decodes pictures that are going to be wanted, all at once; faults are reported when they are.
  void decodeAhead(const std::vector<TextureReference>& references);

  /// A picture is looked for where the URI says, then by its file name alone beside the file that
  /// names it, in the model's materials/textures and in media/materials/textures of resource
  /// folders, as Gazebo's resource system does. For one of Gazebo's own that is not there, a
  /// stand-in is painted.
  /// @return null for Gazebo's normals of a flat surface where they are not there
  /// @throws Error if it is missing or cannot be decoded ("texture 'x.png': no such file; ...")
  [[nodiscard]] std::shared_ptr<const Texture> load(const TextureReference& reference);

  /// The picture that is painted in place of one of Gazebo's ("wood.jpg").
  [[nodiscard]] std::shared_ptr<const Texture> standIn(const std::string& picture);

  /// Gazebo's pictures that stand-ins were painted for since this was asked last.
  [[nodiscard]] std::set<std::string> takeStandIns() { return std::exchange(stand_ins_, {}); }

  /// A picture with another's alpha channel, brought to its size.
  /// @throws Error as `load`
  [[nodiscard]] std::shared_ptr<const Texture> loadWithOpacity(const TextureReference& colour,
                                                               const TextureReference& opacity);

  /// A picture's colours times another's, in the size of the larger one.
  /// @throws Error as `load`
  [[nodiscard]] std::shared_ptr<const Texture> loadProduct(const TextureReference& colour,
                                                           const TextureReference& factor);

  /// A picture that is not a file's.
  /// @param make  called the first time that the name is asked for; gives CV_8UC4
  [[nodiscard]] std::shared_ptr<const Texture> made(const std::string& name,
                                                    const std::function<cv::Mat()>& make);

 private:
  [[nodiscard]] std::optional<std::filesystem::path> lookUp(
      const TextureReference& reference) const;
  [[nodiscard]] std::filesystem::path find(const TextureReference& reference) const;
  [[nodiscard]] const cv::Mat& pixels(const std::string& key,
                                      const std::function<std::vector<std::uint8_t>()>& read);

  using Key = std::tuple<std::string, AlphaMeaning, PictureContent>;

  const ResourceFinder& finder_;
  std::map<std::string, std::variant<cv::Mat, std::string>> pixels_;  ///< or why there are none
  std::map<Key, std::shared_ptr<const Texture>> textures_;
  std::map<std::pair<const Texture*, const Texture*>, std::shared_ptr<const Texture>> with_opacity_;
  std::map<std::pair<const Texture*, const Texture*>, std::shared_ptr<const Texture>> products_;
  std::set<std::string> stand_ins_;
  std::vector<std::shared_ptr<const EmbeddedPicture>> embedded_;  ///< keeps their addresses unique
};

}  // namespace synthetic_dataset::world
