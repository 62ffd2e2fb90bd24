#pragma once

#include <string>

namespace synthetic_dataset::randomize {

/// How map_server interprets a picture's shades: only free, occupied and unknown; grades between
/// these; or each shade as a value (http://wiki.ros.org/map_server#Value_Interpretation).
enum class MapMode { kTrinary, kScale, kRaw };

/// The content of a map_server YAML file for an occupancy map (http://wiki.ros.org/map_server).
struct MapFile {
  std::string image;        ///< the picture's file; relative paths start from the YAML's folder
  double resolution = 0.0;  ///< side of a cell [m]
  double x = 0.0;           ///< of the lower left cell's corner [m]
  double y = 0.0;           ///< [m]
  double yaw = 0.0;         ///< of the map about that corner [rad]
  bool negate = false;      ///< white is occupied, black is free
  double occupied_threshold = 0.0;  ///< a cell is occupied above it; 0 to 1
  double free_threshold = 0.0;      ///< a cell is free below it; less than the other
  MapMode mode = MapMode::kTrinary;
};

/// Reads a map_server YAML file, with the same required fields; unknown fields are ignored, as
/// map_server does.
/// @throws ErrorList with all faults, each starting with the file and naming the field
[[nodiscard]] MapFile readMapYaml(const std::string& file);

}  // namespace synthetic_dataset::randomize
