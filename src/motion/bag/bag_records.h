#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <string_view>

namespace synthetic_dataset::motion {

/// The header of a bag's record (http://wiki.ros.org/Bags/Format/2.0): fields `name=value`, each
/// preceded by its length.
class BagHeader {
 public:
  BagHeader() = default;

  /// @throws Error if a length leads beyond the header's end
  explicit BagHeader(std::string_view bytes);

  [[nodiscard]] bool has(const std::string& name) const { return fields_.count(name) != 0; }
  /// @throws Error if the field is missing
  [[nodiscard]] const std::string& text(const std::string& name) const;
  /// A little-endian number. @throws Error if the field is missing or of another size
  [[nodiscard]] std::uint64_t number(const std::string& name, std::size_t bytes) const;
  /// The kind of record. @throws Error if it has none
  [[nodiscard]] std::uint64_t operation() const { return number("op", 1); }

 private:
  std::map<std::string, std::string> fields_;
};

/// Kinds of records.
inline constexpr std::uint64_t kMessageDefinition = 0x01;  ///< only in version 1.2
inline constexpr std::uint64_t kMessageData = 0x02;
inline constexpr std::uint64_t kFileHeader = 0x03;
inline constexpr std::uint64_t kIndexData = 0x04;
inline constexpr std::uint64_t kChunk = 0x05;
inline constexpr std::uint64_t kChunkInfo = 0x06;
inline constexpr std::uint64_t kConnection = 0x07;

/// A little-endian number in a bag; all of its bytes have to be there.
[[nodiscard]] std::uint64_t littleEndian(std::string_view bytes);

/// A cursor over bytes that contain numbers and headers. Methods throw Error if the bytes end too
/// early.
class BagBytes {
 public:
  virtual ~BagBytes() = default;
  BagBytes() = default;
  BagBytes(const BagBytes&) = delete;
  BagBytes& operator=(const BagBytes&) = delete;

  [[nodiscard]] virtual std::uint64_t size() const = 0;
  [[nodiscard]] std::uint64_t place() const { return place_; }
  void goTo(std::uint64_t place);
  void skip(std::uint64_t bytes);
  [[nodiscard]] std::string take(std::uint64_t bytes);
  [[nodiscard]] std::uint64_t number(std::size_t bytes) { return littleEndian(take(bytes)); }
  /// A header, preceded by its length.
  [[nodiscard]] BagHeader header();

 private:
  /// Reads bytes that are known to exist.
  virtual void read(std::uint64_t from, std::string& into) = 0;

  std::uint64_t place_ = 0;
};

/// The bytes of a file.
class BagFileBytes : public BagBytes {
 public:
  explicit BagFileBytes(const std::string& file);
  [[nodiscard]] std::uint64_t size() const override { return size_; }

 private:
  void read(std::uint64_t from, std::string& into) override;

  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

/// The bytes of a decompressed chunk.
class BagChunkBytes : public BagBytes {
 public:
  /// @param bytes  has to outlive this
  explicit BagChunkBytes(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }

 private:
  void read(std::uint64_t from, std::string& into) override;

  std::string_view bytes_;
};

}  // namespace synthetic_dataset::motion
