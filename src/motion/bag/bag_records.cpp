#include "motion/bag/bag_records.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kLength = 4;  // [byte] of a length

/// [byte]; librosbag accepts fields of up to 1,000,000, which include type definitions.
constexpr std::uint64_t kLongestHeader = 16U << 20U;

}  // namespace

std::uint64_t littleEndian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

BagHeader::BagHeader(std::string_view bytes) {
  while (!bytes.empty()) {
    if (bytes.size() < kLength) throw Error("a record's header breaks off");
    const std::uint64_t length = littleEndian(bytes.substr(0, kLength));
    bytes.remove_prefix(kLength);
    if (length > bytes.size()) throw Error("a field of a record goes beyond its header");
    const std::string_view field = bytes.substr(0, length);
    bytes.remove_prefix(length);
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) throw Error("a field of a record has no '='");
    fields_[std::string(field.substr(0, equals))] = field.substr(equals + 1);
  }
}

const std::string& BagHeader::text(const std::string& name) const {
  const auto found = fields_.find(name);
  if (found == fields_.end()) throw Error("a record has no field '" + name + "'");
  return found->second;
}

std::uint64_t BagHeader::number(const std::string& name, std::size_t bytes) const {
  const std::string& content = text(name);
  if (content.size() == bytes) return littleEndian(content);
  throw Error("a record's field '" + name + "' has " + std::to_string(content.size()) +
              " bytes; it should have " + std::to_string(bytes));
}

void BagBytes::goTo(std::uint64_t place) {
  if (place > size()) throw Error("a record is said to lie beyond the end");
  place_ = place;
}

void BagBytes::skip(std::uint64_t bytes) {
  if (bytes > size() - place_) throw Error("a record goes beyond the end");
  place_ += bytes;
}

std::string BagBytes::take(std::uint64_t bytes) {
  const std::uint64_t from = place_;
  skip(bytes);
  std::string result(bytes, '\0');
  read(from, result);
  return result;
}

BagHeader BagBytes::header() {
  const std::uint64_t length = number(kLength);
  if (length > kLongestHeader) throw Error("a record's header is too long to be one");
  return BagHeader(take(length));
}

BagFileBytes::BagFileBytes(const std::string& file) : stream_(file, std::ios::binary) {
  stream_.seekg(0, std::ios::end);
  size_ = stream_ ? static_cast<std::uint64_t>(stream_.tellg()) : 0;
}

void BagFileBytes::read(std::uint64_t from, std::string& into) {
  stream_.seekg(static_cast<std::streamoff>(from));
  stream_.read(into.data(), static_cast<std::streamsize>(into.size()));
  if (!stream_) throw Error("it cannot be read");
}

void BagChunkBytes::read(std::uint64_t from, std::string& into) {
  bytes_.copy(into.data(), into.size(), from);
}

}  // namespace synthetic_dataset::motion
