#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace synthetic_dataset::base {

/// Compresses runs of bytes 0 and 255, as the rows of masks are, to a zlib stream (RFC 1950 and
/// 1951): literals and repetitions of the byte before, in one block with a Huffman code made for
/// them. Takes the time of the runs, not of the bytes, so that a mask costs a tenth of what zlib
/// takes to find out that there is hardly anything in it.
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
  std::uint64_t pending_ = 0;  ///< bits that make no whole byte yet, the first ones lowest
  int pending_count_ = 0;
  std::uint8_t run_byte_ = 0;
  std::size_t run_count_ = 0;
  std::uint64_t sum_ = 1;   ///< of Adler-32: of all bytes
  std::uint64_t sums_ = 0;  ///< and of all these sums
};

}  // namespace synthetic_dataset::base
