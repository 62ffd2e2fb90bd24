#include "motion/recorded/cloud_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "motion/bag/ros_time.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

/// Scanners have at most a few hundred rings; clouds with more rows are not organised by ring.
constexpr double kMostRings = 4096.0;

/// The longest time between a point's measurement and the stamp.
constexpr Duration kFarthestTime = std::chrono::seconds(1);

std::size_t sizeOf(const PointField& field) {
  switch (field.datatype) {
    case PointField::INT8:
    case PointField::UINT8:
      return 1;
    case PointField::INT16:
    case PointField::UINT16:
      return 2;
    case PointField::FLOAT64:
      return 8;
    default:
      return 4;
  }
}

bool isFloating(const PointField& field) {
  return field.datatype == PointField::FLOAT32 || field.datatype == PointField::FLOAT64;
}

template <class Number>
double numberIn(const std::uint8_t* bytes, bool is_bigendian) {
  std::array<std::uint8_t, sizeof(Number)> in_order{};
  std::copy_n(bytes, in_order.size(), in_order.begin());
  if (is_bigendian) std::reverse(in_order.begin(), in_order.end());
  Number number{};
  std::memcpy(&number, in_order.data(), sizeof number);
  return static_cast<double>(number);
}

/// A field of a cloud's points.
class CloudField {
 public:
  /// @throws Error if it is not of a known type, or ends beyond the point
  CloudField(const PointCloud2& cloud, const PointField& field)
      : field_(field), is_bigendian_(cloud.is_bigendian != 0) {
    if (field.datatype < PointField::INT8 || field.datatype > PointField::FLOAT64) {
      throw Error("has a field " + field.name + " of type " + std::to_string(field.datatype) +
                  ", which sensor_msgs/PointField does not have");
    }
    if (std::uint64_t{field.offset} + sizeOf(field) > cloud.point_step) {
      throw Error("has points of " + std::to_string(cloud.point_step) +
                  " bytes (point_step), and its field " + field.name + " ends at " +
                  std::to_string(std::uint64_t{field.offset} + sizeOf(field)));
    }
  }

  [[nodiscard]] const PointField& description() const { return field_; }

  /// @param point  the bytes of the point
  [[nodiscard]] double of(const std::uint8_t* point) const {
    const std::uint8_t* const bytes = point + field_.offset;
    switch (field_.datatype) {
      case PointField::INT8:
        return numberIn<std::int8_t>(bytes, is_bigendian_);
      case PointField::UINT8:
        return numberIn<std::uint8_t>(bytes, is_bigendian_);
      case PointField::INT16:
        return numberIn<std::int16_t>(bytes, is_bigendian_);
      case PointField::UINT16:
        return numberIn<std::uint16_t>(bytes, is_bigendian_);
      case PointField::INT32:
        return numberIn<std::int32_t>(bytes, is_bigendian_);
      case PointField::UINT32:
        return numberIn<std::uint32_t>(bytes, is_bigendian_);
      case PointField::FLOAT32:
        return numberIn<float>(bytes, is_bigendian_);
      default:
        return numberIn<double>(bytes, is_bigendian_);
    }
  }

 private:
  PointField field_;
  bool is_bigendian_;
};

/// The first of these fields that exists.
std::optional<CloudField> fieldOf(const PointCloud2& cloud, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                    [&](const PointField& each) { return each.name == name; });
    if (field != cloud.fields.end()) return CloudField(cloud, *field);
  }
  return std::nullopt;
}

/// The fields x, y and z.
/// @throws Error if one is missing, or is not a floating-point number
std::vector<CloudField> coordinatesOf(const PointCloud2& cloud) {
  std::vector<CloudField> found;
  for (const char* const name : {"x", "y", "z"}) {
    const auto field = fieldOf(cloud, {name});
    if (!field) {
      std::string there;
      for (const PointField& each : cloud.fields) there += (there.empty() ? "" : ", ") + each.name;
      throw Error("has no field " + std::string(name) + "; it has " +
                  (there.empty() ? "none" : there) + ", and x, y, z are needed");
    }
    if (!isFloating(field->description())) {
      throw Error("has a field " + std::string(name) + " of type " +
                  std::to_string(field->description().datatype) +
                  "; it should be FLOAT32 (7) or FLOAT64 (8)");
    }
    found.push_back(*field);
  }
  return found;
}

/// @throws Error if it has too few bytes
void checkSize(const PointCloud2& cloud) {
  const std::uint64_t row = std::uint64_t{cloud.point_step} * cloud.width;
  if (cloud.height > 1 && cloud.row_step < row) {
    throw Error("has rows of " + std::to_string(cloud.row_step) + " bytes (row_step); its " +
                std::to_string(cloud.width) + " points need " + std::to_string(row));
  }
  if (cloud.height == 0 || cloud.width == 0) return;
  const std::uint64_t needed = std::uint64_t{cloud.row_step} * (cloud.height - 1) + row;
  if (cloud.data.size() >= needed) return;
  throw Error("has " + std::to_string(cloud.data.size()) + " bytes; its " +
              std::to_string(cloud.width) + " x " + std::to_string(cloud.height) + " points need " +
              std::to_string(needed));
}

/// Passes the bytes of each point, and its row, to `see`.
template <class See>
void forEachCell(const PointCloud2& cloud, const See& see) {
  for (std::uint32_t row = 0; row < cloud.height; ++row) {
    const std::uint8_t* point = cloud.data.data() + std::size_t{row} * cloud.row_step;
    for (std::uint32_t i = 0; i < cloud.width; ++i, point += cloud.point_step) see(point, row);
  }
}

Eigen::Vector3d positionAt(const std::uint8_t* point, const std::vector<CloudField>& xyz) {
  return {xyz[0].of(point), xyz[1].of(point), xyz[2].of(point)};
}

/// Converts the number in a point's time field to its time since the stamp [ns].
using TimeReading = std::function<double(double number)>;

/// The fields of a cloud's points, and their interpretation.
class CloudReader {
 public:
  /// @throws Error as measuredCloud does
  explicit CloudReader(const PointCloud2& cloud) : cloud_(cloud), xyz_(coordinatesOf(cloud)) {
    checkSize(cloud);
    time_ = fieldOf(cloud, {"time", "t", "timestamp"});
    intensity_ = fieldOf(cloud, {"intensity", "reflectivity"});
    ring_ = fieldOf(cloud, {"ring", "line"});
    if (time_) findTimes();
  }

  [[nodiscard]] const TimeRange& times() const { return times_; }

  [[nodiscard]] MeasuredCloud read() const {
    MeasuredCloud measured;
    std::vector<std::uint32_t> cells;  // number of each ring's cells so far
    forEachCell(cloud_, [&](const std::uint8_t* bytes, std::uint32_t row) {
      const std::optional<std::uint32_t> ring = ringAt(bytes, row);
      if (!ring) return;
      if (*ring >= cells.size()) cells.resize(*ring + std::size_t{1}, 0);
      const std::uint32_t column = cells[*ring]++;
      if (!isMeasured(bytes)) return;
      MeasuredPoint& point = measured.points.emplace_back();
      point.position = positionAt(bytes, xyz_);
      if (time_) point.time = timeAt(bytes);
      const double intensity = intensity_ ? intensity_->of(bytes) : 0.0;
      point.intensity = std::isfinite(intensity) ? intensity : 0.0;
      point.ring = *ring;
      point.column = column;
    });
    measured.rings = static_cast<std::uint32_t>(cells.size());
    for (const std::uint32_t count : cells) measured.columns = std::max(measured.columns, count);
    return measured;
  }

 private:
  [[nodiscard]] bool isMeasured(const std::uint8_t* point) const {
    const Eigen::Vector3d position = positionAt(point, xyz_);
    return position.allFinite() && !position.isZero(0.0) &&
           (!time_ || std::isfinite(time_->of(point)));
  }

  [[nodiscard]] Duration timeAt(const std::uint8_t* point) const {
    return Duration(std::llround(reading_(time_->of(point))));
  }

  /// Nothing if nothing was measured and the ring is invalid.
  [[nodiscard]] std::optional<std::uint32_t> ringAt(const std::uint8_t* point,
                                                    std::uint32_t row) const {
    double ring = 0.0;
    if (ring_) {
      ring = ring_->of(point);
    } else if (cloud_.height > 1 && cloud_.height <= kMostRings) {
      ring = row;
    }
    if (ring >= 0.0 && ring < kMostRings) return static_cast<std::uint32_t>(ring);
    if (!isMeasured(point)) return std::nullopt;
    throw Error("has the ring " + std::to_string(ring) + " in its field " +
                ring_->description().name + "; it should be a number from 0, less than " +
                std::to_string(static_cast<int>(kMostRings)));
  }

  /// What the numbers in the time field may mean, the most likely meaning first.
  [[nodiscard]] std::vector<TimeReading> readings() const {
    constexpr double kSecond = 1e9;
    const Stamp stamp = toStamp(cloud_.header.stamp);
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(stamp);
    const auto seconds = static_cast<double>(whole.count());
    const auto rest = static_cast<double>((stamp - whole).count());
    const double unit = isFloating(time_->description()) ? kSecond : 1.0;
    const TimeReading since_stamp = [unit](double number) { return unit * number; };
    const TimeReading since_epoch = [=](double number) {  // differences keep more digits
      return kSecond * (number - seconds) - rest;
    };
    const TimeReading in_nanoseconds = [=](double number) {
      return number - kSecond * seconds - rest;
    };
    if (time_->description().name == "timestamp") return {since_epoch, in_nanoseconds, since_stamp};
    return {since_stamp, since_epoch, in_nanoseconds};
  }

  void findTimes() {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    forEachCell(cloud_, [&](const std::uint8_t* point, std::uint32_t /*row*/) {
      if (!isMeasured(point)) return;
      const double number = time_->of(point);
      least = std::min(least, number);
      greatest = std::max(greatest, number);
    });
    const auto farthest = static_cast<double>(kFarthestTime.count());
    for (const TimeReading& each : readings()) {
      reading_ = each;
      if (least > greatest) return;  // nothing was measured
      if (std::abs(each(least)) > farthest || std::abs(each(greatest)) > farthest) continue;
      times_ = {Duration(std::llround(each(least))), Duration(std::llround(each(greatest)))};
      return;
    }
    throw Error("has points of the times " + std::to_string(least) + " to " +
                std::to_string(greatest) + " in its field " + time_->description().name +
                ", which are more than 1 s from its stamp in all units that drivers use");
  }

  const PointCloud2& cloud_;
  std::vector<CloudField> xyz_;
  std::optional<CloudField> time_;
  std::optional<CloudField> intensity_;
  std::optional<CloudField> ring_;
  TimeReading reading_;
  TimeRange times_;
};

}  // namespace

void checkPositions(const PointCloud2& cloud) {
  (void)coordinatesOf(cloud);
  checkSize(cloud);
}

std::vector<Eigen::Vector3d> positionsOf(const PointCloud2& cloud) {
  const std::vector<CloudField> xyz = coordinatesOf(cloud);
  checkSize(cloud);
  std::vector<Eigen::Vector3d> positions;
  forEachCell(cloud, [&](const std::uint8_t* point, std::uint32_t /*row*/) {
    const Eigen::Vector3d position = positionAt(point, xyz);
    if (position.allFinite()) positions.push_back(position);
  });
  return positions;
}

MeasuredCloud measuredCloud(const PointCloud2& cloud) { return CloudReader(cloud).read(); }

TimeRange timesOf(const PointCloud2& cloud) { return CloudReader(cloud).times(); }

}  // namespace synthetic_dataset::motion
