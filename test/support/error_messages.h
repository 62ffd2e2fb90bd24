#pragma once

#include <functional>
#include <string>
#include <vector>

namespace synthetic_dataset::test {

/// The messages of the Error that an action throws; none if it does not fail.
[[nodiscard]] std::vector<std::string> messagesOf(const std::function<void()>& action);

}  // namespace synthetic_dataset::test
