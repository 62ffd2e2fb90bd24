#pragma once

#include <functional>
#include <string>

namespace synthetic_dataset::base {

/// Called when a step begins that may take long, with what it does: "reading the world 'a.world'".
using OnStage = std::function<void(const std::string& stage)>;

/// For callers that do not report stages.
inline void ignoreStage(const std::string& /*stage*/) {}

}  // namespace synthetic_dataset::base
