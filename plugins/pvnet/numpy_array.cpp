#include "plugins/pvnet/numpy_array.h"

#include <cstdint>
#include <cstring>
#include <string_view>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace {

constexpr std::size_t kAlignment = 64;  // of the numbers in the file
constexpr std::string_view kBeginning("\x93NUMPY\x01\x00", 8);

std::string littleEndian(double number) {
  static_assert(sizeof(double) == sizeof(std::uint64_t), "the format's doubles have 64 bits");
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  std::string bytes;
  for (unsigned shift = 0; shift < 64; shift += 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift));
  }
  return bytes;
}

double numberOf(const char* bytes) {
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < 8; ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  }
  double number = 0.0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

}  // namespace

std::string numpyArray(const std::vector<std::vector<double>>& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                       std::to_string(rows.size()) + ", " + std::to_string(columns) + "), }";
  const std::size_t before = kBeginning.size() + 2;  // the header's length follows, in two bytes
  header.append(kAlignment - 1 - (before + header.size()) % kAlignment, ' ');
  header += '\n';
  std::string bytes(kBeginning);
  bytes += static_cast<char>(static_cast<unsigned char>(header.size() & 0xFFU));
  bytes += static_cast<char>(static_cast<unsigned char>(header.size() >> 8U));
  bytes += header;
  for (const std::vector<double>& row : rows) {
    for (const double number : row) bytes += littleEndian(number);
  }
  return bytes;
}

std::vector<double> numbersOfNumpyArray(const std::string& bytes) {
  const std::size_t end_of_header = bytes.find('\n');
  if (bytes.compare(0, kBeginning.size(), kBeginning) != 0 || end_of_header == std::string::npos) {
    throw Error("this is no NumPy array");
  }
  std::vector<double> numbers;
  for (std::size_t at = end_of_header + 1; at + 8 <= bytes.size(); at += 8) {
    numbers.push_back(numberOf(bytes.data() + at));
  }
  return numbers;
}

}  // namespace synthetic_dataset
