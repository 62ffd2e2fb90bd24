#include "base/diagnostics.h"

#include <algorithm>

namespace synthetic_dataset::base {

std::string Diagnostic::message() const { return where.empty() ? what : where + ": " + what; }

void Diagnostics::add(Diagnostic found) {
  const auto [known, is_new] =
      places_.emplace(std::pair(found.severity, found.message()), all_.size());
  if (is_new) {
    all_.push_back(std::move(found));
  } else {
    all_[known->second].count += found.count;
  }
}

void Diagnostics::add(Severity severity, const std::vector<std::string>& messages) {
  for (const std::string& message : messages) add({severity, "", message});
}

void Diagnostics::add(const Error& thrown) {
  if (const auto* list = dynamic_cast<const ErrorList*>(&thrown)) {
    add(Severity::kError, list->messages());
  } else {
    error("", thrown.what());
  }
}

void Diagnostics::merge(const Diagnostics& other) {
  for (const Diagnostic& each : other.all_) add(each);
}

std::vector<std::string> Diagnostics::messages(Severity severity) const {
  std::vector<std::string> messages;
  for (const Diagnostic& each : all_) {
    if (each.severity == severity) messages.push_back(each.message());
  }
  return messages;
}

bool Diagnostics::hasErrors() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Diagnostic& each) { return each.severity == Severity::kError; });
}

void Diagnostics::throwIfAny() const {
  if (hasErrors()) throw ErrorList(messages(Severity::kError));
}

}  // namespace synthetic_dataset::base
