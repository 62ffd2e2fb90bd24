#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "world/description.h"
#include "world/resource_finder.h"

namespace synthetic_dataset::world {

/// What a picture's alpha channel says: only some materials mean it as holes.
enum class AlphaMeaning { kIgnored, kOpacity };

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
};

/// Decodes each picture once, however many materials name it.
class TextureLoader {
 public:
  explicit TextureLoader(const ResourceFinder& finder) : finder_(finder) {}

  /// A picture is looked for where the URI says, then by its file name alone beside the file that
  /// names it and in the model's materials/textures, as Gazebo's resource system does.
  /// @throws Error if it is missing or cannot be decoded ("texture 'x.png': no such file; ...")
  [[nodiscard]] std::shared_ptr<const Texture> load(const TextureReference& reference);

 private:
  [[nodiscard]] std::filesystem::path find(const TextureReference& reference) const;

  using Key = std::pair<std::string, AlphaMeaning>;

  const ResourceFinder& finder_;
  std::map<Key, std::shared_ptr<const Texture>> files_;
  std::map<std::pair<const EmbeddedPicture*, AlphaMeaning>, std::shared_ptr<const Texture>>
      embedded_;
};

}  // namespace synthetic_dataset::world
