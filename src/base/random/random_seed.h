#pragma once

#include <cstdint>
#include <string_view>

namespace synthetic_dataset::base {

/// The seed of something random: a function of the run's seed, the scene and the purpose alone, so
/// that any scene can be made by itself and one purpose's draws leave those of the others as they
/// are.
[[nodiscard]] std::uint64_t randomSeed(std::uint64_t run_seed, std::int64_t scene_index,
                                       std::string_view purpose);

}  // namespace synthetic_dataset::base
