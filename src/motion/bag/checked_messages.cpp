#include "motion/bag/checked_messages.h"

#include <cstdint>
#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Reads and checks a list's length, which is the next number.
/// @param least  smallest size of an entry [byte]
/// @return the number of entries
std::uint32_t checkList(ros::serialization::IStream& stream, std::uint32_t least,
                        const std::string& name) {
  std::uint32_t count = 0;
  stream.next(count);
  if (count <= stream.getLength() / least) return count;
  throw Error("its list of " + name + " is said to have " + std::to_string(count) +
              " entries, more than its bytes can hold");
}

/// Moves past a list of texts.
void passTexts(ros::serialization::IStream& stream, const std::string& name) {
  const std::uint32_t count = checkList(stream, sizeof(std::uint32_t), name);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t length = 0;
    stream.next(length);
    stream.advance(length);
  }
}

/// Moves past a list of entries of a fixed size.
void passList(ros::serialization::IStream& stream, std::uint32_t size, const std::string& name) {
  stream.advance(checkList(stream, size, name) * size);
}

}  // namespace

void checkLists(ros::serialization::IStream stream, const RecordedTransforms& /*kind*/) {
  // The lengths of two names, a sequence number, a time, and seven numbers.
  constexpr std::uint32_t kLeast = 4 + 4 + 4 + 8 + 7 * 8;
  static_cast<void>(checkList(stream, kLeast, "transforms"));
}

void checkLists(ros::serialization::IStream stream, const RecordedCalibration& /*kind*/) {
  std_msgs::Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string model;
  stream.next(header);
  stream.next(height);
  stream.next(width);
  stream.next(model);
  static_cast<void>(checkList(stream, sizeof(double), "distortion coefficients"));
}

void checkLists(ros::serialization::IStream stream, const RecordedGrid& /*kind*/) {
  std_msgs::Header header;
  nav_msgs::MapMetaData description;
  stream.next(header);
  stream.next(description);
  static_cast<void>(checkList(stream, sizeof(std::int8_t), "cells"));
}

void checkLists(ros::serialization::IStream stream, const RecordedJoints& /*kind*/) {
  std_msgs::Header header;
  stream.next(header);
  passTexts(stream, "joints");
  passList(stream, sizeof(double), "positions");
  passList(stream, sizeof(double), "velocities");
  passList(stream, sizeof(double), "efforts");
}

void checkLists(ros::serialization::IStream stream, const RecordedImage& /*kind*/) {
  std_msgs::Header header;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  stream.next(header);
  stream.advance(2 * sizeof(std::uint32_t));  // height and width
  stream.next(encoding);
  stream.next(is_bigendian);
  stream.advance(sizeof(std::uint32_t));  // step
  static_cast<void>(checkList(stream, sizeof(std::uint8_t), "pixels"));
}

void checkLists(ros::serialization::IStream stream, const RecordedImageFile& /*kind*/) {
  std_msgs::Header header;
  std::string format;
  stream.next(header);
  stream.next(format);
  static_cast<void>(checkList(stream, sizeof(std::uint8_t), "bytes"));
}

void checkLists(ros::serialization::IStream stream, const RecordedCloud& /*kind*/) {
  // The length of a name, an offset, a type, and a count.
  constexpr std::uint32_t kLeast = 4 + 4 + 1 + 4;
  std_msgs::Header header;
  stream.next(header);
  stream.advance(2 * sizeof(std::uint32_t));  // height and width
  const std::uint32_t count = checkList(stream, kLeast, "fields");
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t length = 0;
    stream.next(length);
    stream.advance(length);
    stream.advance(kLeast - sizeof length);
  }
  stream.advance(1 + 2 * sizeof(std::uint32_t));  // byte order, steps
  static_cast<void>(checkList(stream, sizeof(std::uint8_t), "bytes"));
}

void checkLists(ros::serialization::IStream stream, const RecordedStates& /*kind*/) {
  passTexts(stream, "names");
  passList(stream, 7 * sizeof(double), "poses");
}

}  // namespace synthetic_dataset::motion
