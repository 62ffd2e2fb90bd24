#include "random_seed.h"

#include "sensor/mixed_bits.h"

namespace synthetic_dataset {
namespace {

std::uint64_t mixed(std::uint64_t x) { return sensor::mixedBits(x + sensor::kCounterStep); }

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
