#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "plugins/nuscenes/nuscenes_frames.h"
#include "plugins/nuscenes/nuscenes_options.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/label_writer.h"

/// nuScenes' tables, of the frames of a whole dataset.
namespace synthetic_dataset::nuscenes {

/// Takes the records of a table.
using AddRecord = std::function<void(const Json& record)>;

/// A table's name, and what makes it.
struct Table {
  std::string name;
  std::function<void(const AddRecord& add)> make;
};

/// All tables.
/// @param dataset, frames  have to outlive the result; frames are in the order of their scenes
[[nodiscard]] std::vector<Table> tablesOf(const DatasetInfo& dataset,
                                          const std::vector<Frame>& frames,
                                          const NuScenesOptions& options);

/// The numbers of categories that lidarseg's points have: 0 is noise, then come the classes of
/// objects and those of the world, one number for both where they have the same name.
class PointCategories {
 public:
  explicit PointCategories(const DatasetInfo& dataset);

  [[nodiscard]] std::uint8_t of(const CloudPoint& point) const;

  /// The number of a class of the world. @param index  in DatasetInfo::world_classes
  [[nodiscard]] std::size_t ofWorld(std::size_t index) const { return of_world_[index]; }

 private:
  std::vector<std::size_t> of_world_;
};

/// A sample_data's token.
[[nodiscard]] std::string dataToken(const DatasetInfo& dataset, const Frame& frame);

/// The file with the categories of a lidar's points.
[[nodiscard]] std::string lidarsegFile(const std::string& version, const std::string& data_token);

}  // namespace synthetic_dataset::nuscenes
