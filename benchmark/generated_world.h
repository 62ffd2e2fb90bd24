#pragma once

#include <filesystem>
#include <vector>

namespace synthetic_dataset::benchmark {

struct GeneratedWorld {
  std::filesystem::path world;
  std::vector<std::filesystem::path> meshes;
  std::vector<std::filesystem::path> pictures;
};

/// Writes 50 models of about 5,000 triangles each, which share five pictures of 512 x 512 pixels,
/// and a world with these models in rows.
/// @param folder  has to exist and be empty
[[nodiscard]] GeneratedWorld generateWorld(const std::filesystem::path& folder);

}  // namespace synthetic_dataset::benchmark
