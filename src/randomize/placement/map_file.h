#pragma once

#include <string>

namespace synthetic_dataset::randomize {

/// What map_server makes of a picture's shades: free, occupied and unknown only, grades between
/// these, or each shade as it is (http://wiki.ros.org/map_server#Value_Interpretation).
enum class MapMode { kTrinary, kScale, kRaw };

/// What a map_server's YAML file says of an occupancy map (http://wiki.ros.org/map_server).
struct MapFile {
  std::string image;        ///< the picture's file; a relative path is made one from the YAML's
  double resolution = 0.0;  ///< of a cell's side [m]
  double x = 0.0;           ///< of the lower left cell's corner [m]
  double y = 0.0;           ///< [m]
  double yaw = 0.0;         ///< of the map about that corner [rad]
  bool negate = false;      ///< white is occupied, black is free
  double occupied_threshold = 0.0;  ///< above it a cell is occupied; 0 to 1
  double free_threshold = 0.0;      ///< below it a cell is free; less than the other
  MapMode mode = MapMode::kTrinary;
};

/// Reads a map_server's YAML file, with the same fields required; others than its own are passed
/// over, as it does.
/// @throws ErrorList with all faults, each beginning with the file and naming the field
[[nodiscard]] MapFile readMapYaml(const std::string& file);

}  // namespace synthetic_dataset::randomize
