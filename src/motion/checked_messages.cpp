#include "motion/checked_messages.h"

#include <cstdint>
#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// A list's length is the number that comes next.
/// @param least  bytes that an entry has at least
void checkList(ros::serialization::IStream& stream, std::uint32_t least, const std::string& name) {
  std::uint32_t count = 0;
  stream.next(count);
  if (count <= stream.getLength() / least) return;
  throw Error("its list of " + name + " is said to have " + std::to_string(count) +
              " entries, more than its bytes can hold");
}

}  // namespace

void checkTransforms(ros::serialization::IStream stream) {
  // Two names' lengths, a sequence number, a time, seven numbers.
  constexpr std::uint32_t kLeast = 4 + 4 + 4 + 8 + 7 * 8;
  checkList(stream, kLeast, "transforms");
}

void checkCalibration(ros::serialization::IStream stream) {
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string model;
  stream.next(header);
  stream.next(height);
  stream.next(width);
  stream.next(model);
  checkList(stream, sizeof(double), "distortion coefficients");
}

void checkGrid(ros::serialization::IStream stream) {
  std_msgs::Header header;
  nav_msgs::MapMetaData description;
  stream.next(header);
  stream.next(description);
  checkList(stream, sizeof(std::int8_t), "cells");
}

}  // namespace synthetic_dataset::motion
