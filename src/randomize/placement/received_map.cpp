#include "randomize/placement/received_map.h"

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "randomize/placement/occupancy_map.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::randomize {
namespace {

std::string runsOf(const std::vector<std::int8_t>& cells) {
  std::string runs;
  for (std::size_t i = 0; i < cells.size();) {
    std::size_t end = i;
    while (end < cells.size() && cells[end] == cells[i]) ++end;
    if (!runs.empty()) runs += ' ';
    runs += std::to_string(cells[i]) + "x" + std::to_string(end - i);
    i = end;
  }
  return runs;
}

/// Nothing if the text is not a list of runs, or has another number of cells than it should.
std::optional<std::vector<std::int8_t>> cellsOf(const std::string& runs, std::size_t count) {
  std::vector<std::int8_t> cells;
  std::istringstream stream(runs);
  stream.imbue(std::locale::classic());
  int value = 0;
  char times = 0;
  std::size_t length = 0;
  while (stream >> value) {
    if (!(stream >> times >> length) || times != 'x' || value < -128 || value > 127) {
      return std::nullopt;
    }
    if (length > count - cells.size()) return std::nullopt;
    cells.insert(cells.end(), length, static_cast<std::int8_t>(value));
  }
  if (!stream.eof() || cells.size() != count) return std::nullopt;
  return cells;
}

std::size_t sideIn(Parameters& group, const std::string& name) {
  constexpr std::int64_t kLongest = 1000000;
  const auto side = group.required<std::int64_t>(name);
  if (side > 0 && side <= kLongest) return static_cast<std::size_t>(side);
  group.addError(name, "found " + std::to_string(side) + "; it should be 1 to 1e6 cells");
  return 1;
}

Pose originIn(Parameters& group) {
  const auto p = group.required<std::vector<double>>("origin");
  if (p.size() == 7)
    return makePose({p[0], p[1], p[2]}, Eigen::Quaterniond(p[6], p[3], p[4], p[5]));
  group.addError("origin", "found " + std::to_string(p.size()) +
                               " numbers; it should be [x, y, z, qx, qy, qz, qw]");
  return Pose::Identity();
}

}  // namespace

Value settingsOf(const motion::RecordedMap& map) {
  const Eigen::Vector3d p = map.X_FM.translation();
  const Eigen::Quaterniond q(map.X_FM.linear());
  return Value::Map{
      {"frame", Value(map.frame)},
      {"width", Value(static_cast<std::int64_t>(map.width))},
      {"height", Value(static_cast<std::int64_t>(map.height))},
      {"resolution", Value(map.resolution)},
      {"origin", Value(Value::List{Value(p.x()), Value(p.y()), Value(p.z()), Value(q.x()),
                                   Value(q.y()), Value(q.z()), Value(q.w())})},
      {"cells", Value(runsOf(map.cells))}};
}

motion::RecordedMap receivedMap(const Value& settings) {
  Parameters group(settings, "placement/received_map");
  motion::RecordedMap map;
  map.frame = group.required<std::string>("frame");
  map.width = sideIn(group, "width");
  map.height = sideIn(group, "height");
  map.resolution = group.required<double>("resolution");
  map.X_FM = originIn(group);
  const auto runs = group.required<std::string>("cells");
  const std::size_t count = map.width * map.height;
  auto cells = count <= kMostCells ? cellsOf(runs, count) : std::nullopt;
  if (count > kMostCells) {
    group.addError("width", "found " + std::to_string(map.width) + " x " +
                                std::to_string(map.height) + " cells; there should be at most " +
                                std::to_string(kMostCells));
  } else if (cells) {
    map.cells = std::move(*cells);
  } else if (!runs.empty()) {
    group.addError("cells",
                   "it should be runs of equal values that fill width x height cells, "
                   "such as \"0x1200 100x3 -1x40\"");
  }
  if (!group.errors().empty()) throw ErrorList(group.errors());
  motion::checkMap(map);
  return map;
}

}  // namespace synthetic_dataset::randomize
