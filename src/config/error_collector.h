#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::config {

/// Gathers the errors of steps that do not depend on each other, so that the user sees all at once.
class ErrorCollector {
 public:
  /// Runs a step. @return what it answers, or nothing when it failed; of a step that answers
  ///     nothing, whether it went well
  template <class Step>
  auto attempt(const Step& step) {
    if constexpr (std::is_void_v<decltype(step())>) {
      return attemptToAnswer([&] {
               step();
               return true;
             })
          .has_value();
    } else {
      return attemptToAnswer(step);
    }
  }

  void add(const std::vector<std::string>& messages) {
    messages_.insert(messages_.end(), messages.begin(), messages.end());
  }
  void add(std::string message) { messages_.push_back(std::move(message)); }

  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

  /// @throws ErrorList when there was any error
  void throwIfAny() const {
    if (!messages_.empty()) throw ErrorList(messages_);
  }

 private:
  template <class Step>
  auto attemptToAnswer(const Step& step) -> std::optional<decltype(step())> {
    try {
      return step();
    } catch (const ErrorList& errors) {
      add(errors.messages());
    } catch (const Error& error) {
      add(error.what());
    }
    return std::nullopt;
  }

  std::vector<std::string> messages_;
};

}  // namespace synthetic_dataset::config
