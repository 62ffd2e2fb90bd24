#pragma once

#include <functional>
#include <string>
#include <vector>

namespace synthetic_dataset::test {

/// What an action says when it fails: the messages of its Error; none when it does not fail.
[[nodiscard]] std::vector<std::string> messagesOf(const std::function<void()>& action);

}  // namespace synthetic_dataset::test
