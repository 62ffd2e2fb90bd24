#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// Compresses runs of bytes 0 and 255, such as the rows of masks, to a zlib stream (RFC 1950 and
/// 1951): literals and repetitions of the preceding byte, in one block with a Huffman code made for
/// them. Its time grows with the runs, not the bytes, so that a mask takes a tenth of the time that
/// zlib needs to discover how little it contains.
class RunDeflater {
 public:
  RunDeflater();

  /// @param byte  0 or 255
  void add(std::uint8_t byte, std::size_t count);

  /// Ends the stream, after which nothing can be added.
  [[nodiscard]] std::vector<std::uint8_t> finish();

 private:
  void endRun();
  void repeat(std::size_t count);
  void write(std::uint32_t bits, int count);
  void writeSymbol(std::size_t symbol);

  std::vector<std::uint8_t> bytes_;
  std::uint64_t pending_ = 0;  ///< bits that do not fill a byte yet, the first ones lowest
  int pending_count_ = 0;
  std::uint8_t run_byte_ = 0;
  std::size_t run_count_ = 0;
  std::uint64_t sum_ = 1;   ///< Adler-32's sum of all bytes
  std::uint64_t sums_ = 0;  ///< Adler-32's sum of all these sums
};

}  // namespace synthetic_dataset::base
