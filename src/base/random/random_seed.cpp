#include "base/random/random_seed.h"

#include "synthetic_dataset/fingerprint.h"

namespace synthetic_dataset::base {
namespace {

std::uint64_t mixed(std::uint64_t x) { return mixedBits(x + kCounterStep); }

}  // namespace

std::uint64_t randomSeed(std::uint64_t run_seed, std::int64_t scene_index,
                         std::string_view purpose) {
  const std::uint64_t of_scene = mixed(mixed(run_seed) ^ static_cast<std::uint64_t>(scene_index));
  return mixed(of_scene ^ Fingerprint(purpose).value());
}

}  // namespace synthetic_dataset::base
