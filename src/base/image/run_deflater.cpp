#include "base/image/run_deflater.h"

#include <algorithm>
#include <array>
#include <utility>

namespace synthetic_dataset::base {
namespace {

constexpr std::uint64_t kAdlerBase = 65521;
constexpr std::size_t kShortest = 3;  // bytes that a repetition can represent
constexpr std::size_t kLongest = 258;
constexpr std::size_t kEnd = 256;  // the symbol after the last one of a block
constexpr std::size_t kFirstLength = 257;
constexpr std::size_t kLongestLength = 285;
constexpr std::size_t kSymbols = 286;

/// A word of a Huffman code, its first bit lowest.
struct Word {
  std::uint32_t bits = 0;
  int count = 0;
};

/// Words of the given lengths, by the rule of RFC 1951, 3.2.2.
template <std::size_t kSize>
std::array<Word, kSize> codeOf(const std::array<int, kSize>& lengths) {
  constexpr int kLongestWord = 15;
  std::array<Word, kSize> code;
  std::uint32_t next = 0;
  for (int length = 1; length <= kLongestWord; ++length) {
    next <<= 1U;
    for (std::size_t symbol = 0; symbol < kSize; ++symbol) {
      if (lengths.at(symbol) != length) continue;
      Word& word = code.at(symbol);
      word.count = length;
      for (int bit = 0; bit < length; ++bit) {
        word.bits |= (next >> static_cast<unsigned>(bit) & 1U)
                     << static_cast<unsigned>(length - 1 - bit);
      }
      ++next;
    }
  }
  return code;
}

/// Most of a mask is repetitions of the greatest length, which therefore has the shortest word;
/// black, white and the rest share the other words.
std::array<int, kSymbols> symbolLengths() {
  std::array<int, kSymbols> lengths{};
  lengths[0] = lengths[255] = 3;
  std::fill(lengths.begin() + kEnd, lengths.begin() + 282, 7);
  lengths[282] = lengths[283] = lengths[284] = 6;
  lengths[kLongestLength] = 1;
  return lengths;
}

const std::array<Word, kSymbols>& symbols() {
  static const std::array<Word, kSymbols> kCode = codeOf(symbolLengths());
  return kCode;
}

/// How a repetition's length is coded: a symbol, and bits beyond it (RFC 1951, 3.2.5).
struct Length {
  std::size_t symbol = 0;
  std::uint32_t extra = 0;
  int extra_count = 0;
};

Length lengthOf(std::size_t count) {
  if (count == kLongest) return {kLongestLength, 0, 0};
  std::size_t first = kShortest;
  std::size_t symbol = kFirstLength;
  for (int extra_count = 0;; ++extra_count) {
    // The first eight symbols represent one length each; then, in groups of four, each symbol
    // represents twice as many as in the group before.
    const std::size_t group = extra_count == 0 ? 8 : 4;
    const std::size_t each = std::size_t{1} << static_cast<unsigned>(extra_count);
    if (count < first + group * each) {
      const std::size_t place = (count - first) / each;
      return {symbol + place, static_cast<std::uint32_t>((count - first) % each), extra_count};
    }
    first += group * each;
    symbol += group;
  }
}

}  // namespace

RunDeflater::RunDeflater() {
  // RFC 1950: deflate with a window of 32 kB, fastest level.
  bytes_ = {0x78, 0x01};
  write(1, 1);  // the last block
  write(2, 2);  // with a code of its own, which follows (RFC 1951, 3.2.7)
  write(kSymbols - 257, 5);
  write(0, 5);  // one distance: that of the preceding byte
  // The lengths of words have a code of their own, whose word lengths come first.
  constexpr std::size_t kRepeat = 16;  // repeats the preceding length 3 to 6 times
  constexpr std::size_t kZeros = 18;   // 11 to 138 zeros
  constexpr std::array<std::size_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                  11, 4,  12, 3, 13, 2, 14, 1, 15};
  std::array<int, 19> lengths{};
  lengths[kRepeat] = lengths[7] = 2;
  lengths[kZeros] = lengths[1] = lengths[3] = lengths[6] = 3;
  const std::array<Word, 19> code = codeOf(lengths);
  constexpr std::size_t kSent = 18;  // entries of kOrder: all up to that of 1
  write(kSent - 4, 4);
  for (std::size_t i = 0; i < kSent; ++i)
    write(static_cast<std::uint32_t>(lengths.at(kOrder.at(i))), 3);
  const auto writeCode = [&](std::size_t symbol) {
    write(code.at(symbol).bits, code.at(symbol).count);
  };
  writeCode(3);  // black
  for (const std::uint32_t zeros : {138U, 116U}) {
    writeCode(kZeros);
    write(zeros - 11, 7);
  }
  writeCode(3);  // white
  writeCode(7);  // the end and 25 lengths
  for (int i = 0; i < 4; ++i) {
    writeCode(kRepeat);
    write(6 - 3, 2);
  }
  writeCode(7);
  for (int i = 0; i < 3; ++i) writeCode(6);
  writeCode(1);  // the longest
  writeCode(1);  // the one distance
}

void RunDeflater::add(std::uint8_t byte, std::size_t count) {
  if (byte != run_byte_) endRun();
  run_byte_ = byte;
  run_count_ += count;
}

std::vector<std::uint8_t> RunDeflater::finish() {
  endRun();
  writeSymbol(kEnd);
  if (pending_count_ > 0) write(0, 8 - pending_count_);
  for (const std::uint64_t part : {sums_ >> 8U, sums_, sum_ >> 8U, sum_}) {
    bytes_.push_back(static_cast<std::uint8_t>(part));
  }
  return std::move(bytes_);
}

void RunDeflater::endRun() {
  if (run_count_ == 0) return;
  // The same as adding byte after byte.
  const std::uint64_t count = run_count_ % kAdlerBase;
  const std::uint64_t steps = run_count_ * (run_count_ + 1) / 2 % kAdlerBase;
  sums_ = (sums_ + count * sum_ + run_byte_ * steps) % kAdlerBase;
  sum_ = (sum_ + run_byte_ * count) % kAdlerBase;
  writeSymbol(run_byte_);
  std::size_t left = run_count_ - 1;
  for (; left >= kShortest; left -= std::min(left, kLongest)) repeat(std::min(left, kLongest));
  for (; left > 0; --left) writeSymbol(run_byte_);
  run_count_ = 0;
}

void RunDeflater::repeat(std::size_t count) {
  const Length length = lengthOf(count);
  writeSymbol(length.symbol);
  write(length.extra, length.extra_count);
  write(0, 1);  // the one distance
}

void RunDeflater::write(std::uint32_t bits, int count) {
  pending_ |= std::uint64_t{bits} << static_cast<unsigned>(pending_count_);
  pending_count_ += count;
  for (; pending_count_ >= 8; pending_count_ -= 8, pending_ >>= 8U) {
    bytes_.push_back(static_cast<std::uint8_t>(pending_));
  }
}

void RunDeflater::writeSymbol(std::size_t symbol) {
  const Word& word = symbols().at(symbol);
  write(word.bits, word.count);
}

}  // namespace synthetic_dataset::base
