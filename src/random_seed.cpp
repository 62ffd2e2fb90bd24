#include "random_seed.h"

namespace synthetic_dataset {
namespace {

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014): every bit in changes half of those
/// out.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

/// FNV-1a (http://www.isthe.com/chongo/tech/comp/fnv/).
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  }
  return hash;
}

}  // namespace

std::uint64_t randomSeed(std::uint64_t run_seed, std::int64_t scene_index,
                         std::string_view purpose) {
  return mixed(mixed(mixed(run_seed) ^ static_cast<std::uint64_t>(scene_index)) ^ hashOf(purpose));
}

}  // namespace synthetic_dataset
