#pragma once

#include <exception>
#include <functional>
#include <string>

namespace synthetic_dataset::base {

/// Called when a potentially long step begins, with what it does: "reading the world 'a.world'".
using OnStage = std::function<void(const std::string& stage)>;

/// What a call of OnStage may throw to abort a long step. It is not an Error: nothing is wrong.
class Interrupted : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "broken off"; }
};

/// For callers that do not report stages.
inline void ignoreStage(const std::string& /*stage*/) {}

}  // namespace synthetic_dataset::base
