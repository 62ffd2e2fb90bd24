#pragma once

#include <filesystem>
#include <functional>

namespace tinyxml2 {
class XMLElement;
}

namespace synthetic_dataset::world {

/// The attribute that tells, of a model that stands in another file than its own, which that is.
inline constexpr const char* kJoinedFrom = "synthetic_dataset:file";

/// What an `<include>` draws in.
struct IncludedFile {
  const tinyxml2::XMLElement* root = nullptr;  ///< or null, where it is not known
  std::filesystem::path file;
};

/// Puts models in the place of the `<include>`s of a world, with the name, pose and <static> that
/// those give them. libsdformat copies its whole description of SDF for each include (20 ms and
/// 2.5 MB; 12.3), and none for a model that stands in the world itself.
///
/// An include stays where the two may not be the same: of another version of SDF, which is
/// converted otherwise; with settings that are rare; of files that are no single model; and beyond
/// some megabytes of text.
/// @param root  of the world's file, its includes named by path
/// @param included  gives what a path is the copy of
/// @return whether there was any
bool joinModels(tinyxml2::XMLElement& root,
                const std::function<IncludedFile(const std::filesystem::path&)>& included);

}  // namespace synthetic_dataset::world
