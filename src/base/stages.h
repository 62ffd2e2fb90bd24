#pragma once

#include <functional>
#include <string>

namespace synthetic_dataset::base {

/// Called when a step begins that may take long, with what it does: "reading the world 'a.world'".
using OnStage = std::function<void(const std::string& stage)>;

/// Of whoever does not want to know.
inline void ignoreStage(const std::string& /*stage*/) {}

}  // namespace synthetic_dataset::base
