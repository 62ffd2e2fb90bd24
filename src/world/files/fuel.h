#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// The parts of a URI of Gazebo's model server:
/// `https://<server>/[1.0/]<owner>/[fuel/]models/<name>[/<version>][/files/<path>]`.
struct FuelUri {
  std::string server;
  std::string owner;
  std::string kind;     ///< "models" or "worlds"
  std::string name;     ///< percent escapes decoded
  std::string version;  ///< a number; empty for the newest
  std::string path;     ///< of a file within the model; empty for the model itself
};

/// @return nothing unless it is a URI of such a server
[[nodiscard]] std::optional<FuelUri> parseFuelUri(const std::string& uri);

/// The folders in which Gazebo's tools keep what they have downloaded: those of GZ_FUEL_CACHE_PATH
/// and IGN_FUEL_CACHE_PATH, then ~/.gz/fuel and ~/.ignition/fuel.
[[nodiscard]] std::vector<std::filesystem::path> fuelCaches();

/// The paths at which the caches would hold it, in the order in which to try them:
/// `<cache>/<server>/<owner>/models/<name>/<version>/<path>`, with owner and name in lower case.
/// Without a version, the highest one that is there.
[[nodiscard]] std::vector<std::filesystem::path> fuelPlaces(
    const FuelUri& uri, const std::vector<std::filesystem::path>& caches);

/// Decodes percent escapes, such as "%20" for a space (RFC 3986, section 2.1).
[[nodiscard]] std::string percentDecoded(const std::string& text);

}  // namespace synthetic_dataset::world
