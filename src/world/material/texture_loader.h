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

/// What a picture's alpha channel means: only some materials use it for holes.
enum class AlphaMeaning { kIgnored, kOpacity };

/// How the channels of a picture are used.
enum class PictureContent {
  kColour,       ///< as they are
  kRed,          ///< the red channel in all three: one number per pixel
  kInvertedRed,  ///< 1 minus the red channel in all three: glossiness as roughness
  /// A normal map; a grey picture is taken for heights and converted to a normal map. Mesh files
  /// name both kinds alike.
  kNormalsOrHeights,
  kAlphaFromGrey,  ///< an opacity picture: its grey as alpha, white as its colour
};

/// A picture that a mesh file carries within itself.
struct EmbeddedPicture {
  std::string name;                 ///< for messages
  std::vector<std::uint8_t> bytes;  ///< a complete picture file
};

/// How a mesh file or a material names its picture.
struct TextureReference {
  std::string uri;
  std::filesystem::path folder;  ///< of the file that names it
  std::shared_ptr<const EmbeddedPicture> embedded;
  AlphaMeaning alpha = AlphaMeaning::kIgnored;
  PictureContent content = PictureContent::kColour;
  std::vector<std::filesystem::path> more_folders;  ///< where its file name is looked for, too
};

/// Decodes each picture once, however many materials name it.
class TextureLoader {
 public:
  explicit TextureLoader(const ResourceFinder& finder) : finder_(finder) {}
  explicit TextureLoader(ResourceFinder&&) = delete;  // it has to outlive this

  /// Decodes pictures that will be needed, all at once; errors are reported when they are loaded.
  void decodeAhead(const std::vector<TextureReference>& references);

  /// Loads a picture. It is looked for where the URI says, then by its file name alone next to the
  /// file that names it, in the model's materials/textures and in media/materials/textures of
  /// resource folders, as Gazebo's resource system does. For one of Gazebo's own that is not there,
  /// a stand-in is painted.
  /// @return null for Gazebo's normal map of a flat surface if it is not there
  /// @throws Error if it is missing or cannot be decoded ("texture 'x.png': no such file; ...")
  [[nodiscard]] std::shared_ptr<const Texture> load(const TextureReference& reference);

  /// The stand-in for one of Gazebo's pictures ("wood.jpg"); null for the normal map of a flat
  /// surface.
  [[nodiscard]] std::shared_ptr<const Texture> standIn(const std::string& picture);

  /// Gazebo's pictures for which stand-ins were painted since the last call.
  [[nodiscard]] std::set<std::string> takeStandIns() { return std::exchange(stand_ins_, {}); }

  /// A picture with another's alpha channel, brought to its size.
  /// @throws Error as `load`
  [[nodiscard]] std::shared_ptr<const Texture> loadWithOpacity(const TextureReference& colour,
                                                               const TextureReference& opacity);

  /// The product of two pictures' colours, in the size of the larger one.
  /// @throws Error as `load`
  [[nodiscard]] std::shared_ptr<const Texture> loadProduct(const TextureReference& colour,
                                                           const TextureReference& factor);

  /// A picture that does not come from a file.
  /// @param make  called the first time that the name is asked for; returns CV_8UC4
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
