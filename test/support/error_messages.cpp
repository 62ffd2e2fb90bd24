#include "support/error_messages.h"

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::test {

std::vector<std::string> messagesOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const ErrorList& list) {
    return list.messages();
  } catch (const Error& error) {
    return {error.what()};
  }
  return {};
}

}  // namespace synthetic_dataset::test
