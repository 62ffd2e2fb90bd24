#include "motion/recorded/recorded_map.h"

#include <cmath>
#include <optional>
#include <utility>

#include "motion/bag/checked_messages.h"
#include "motion/bag/topic_search.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::motion {
namespace {

struct LastGrid {
  Stamp recorded{0};
  nav_msgs::OccupancyGrid message;
};

/// Replaces `last` by the bag's last message on the search's topic, unless `last` is more recent.
void takeLast(const std::string& file, TopicSearch& search, std::optional<LastGrid>& last) {
  search.in(file, [&](BagMessages& messages) {
    // Maps are large: only the last one is decoded.
    std::optional<BagMessage> last_here;
    while (auto message = messages.next()) last_here = std::move(message);
    if (!last_here || (last && last_here->recorded < last->recorded)) return;
    const auto grid = last_here->instantiate<RecordedGrid>();
    if (grid) last = {last_here->recorded, grid->message};
  });
}

std::string sidesOf(const RecordedMap& map) {
  return std::to_string(map.width) + " x " + std::to_string(map.height) + " cells";
}

/// An orientation of all zeros, which a sender has not set, counts as no rotation, as in RViz.
Pose poseOf(const geometry_msgs::Pose& origin) {
  const auto& p = origin.position;
  const auto& q = origin.orientation;
  return makePose({p.x, p.y, p.z}, Eigen::Quaterniond(q.w, q.x, q.y, q.z));
}

}  // namespace

void checkMap(const RecordedMap& map) {
  if (map.width == 0 || map.height == 0) {
    throw Error("found a map of " + sidesOf(map) + "; it should have some");
  }
  if (map.cells.size() / map.width != map.height || map.cells.size() % map.width != 0) {
    throw Error("found a map of " + sidesOf(map) + " with " + std::to_string(map.cells.size()) +
                " values; it should have one for each cell");
  }
  if (!std::isfinite(map.resolution) || map.resolution <= 0.0) {
    throw Error("found a resolution of " + Value(map.resolution).text() +
                " m; it should be above 0");
  }
  if (!map.X_FM.matrix().allFinite()) {
    throw Error("found an origin that is not a pose; its numbers should be finite");
  }
}

RecordedMap readMap(const std::vector<std::string>& bag_files, const std::string& topic) {
  auto search = TopicSearch::of<nav_msgs::OccupancyGrid>(topic);
  std::optional<LastGrid> last;
  for (const std::string& file : bag_files) takeLast(file, search, last);
  if (!last) throw search.notFound();
  try {
    return mapOf(last->message);
  } catch (const Error& error) {
    throw Error("the last map of '" + topic + "': " + error.what());
  }
}

RecordedMap mapOf(const nav_msgs::OccupancyGrid& grid) {
  RecordedMap map{grid.info.width,
                  grid.info.height,
                  grid.info.resolution,
                  poseOf(grid.info.origin),
                  withoutLeadingSlashes(grid.header.frame_id),
                  grid.data};
  checkMap(map);
  return map;
}

}  // namespace synthetic_dataset::motion
