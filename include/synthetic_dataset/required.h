#pragma once

#include <optional>
#include <utility>

namespace synthetic_dataset {
inline namespace v2 {

/// @throws Error that says what was asked for, and what would have it computed
[[noreturn]] void throwNotRequired(const char* name, const char* requirement);

/// Something that is computed only where the requirements of a writer ask for it. Asking for it
/// elsewhere throws: what is not known must not look like nothing.
template <class T>
class Required {
 public:
  /// @param name  what it is called, for the message: "Scene::depth"
  /// @param requirement  the member of Requirements that asks for it: "depth"
  Required(const char* name, const char* requirement) : name_(name), requirement_(requirement) {}

  /// What was computed.
  /// @throws Error where no writer of the run requires it
  [[nodiscard]] const T& operator()() const {
    if (!value_) throwNotRequired(name_, requirement_);
    return *value_;
  }

  [[nodiscard]] bool isKnown() const { return value_.has_value(); }

  Required& operator=(T value) {
    value_.emplace(std::move(value));
    return *this;
  }

 private:
  const char* name_;
  const char* requirement_;
  std::optional<T> value_;
};

}  // namespace v2
}  // namespace synthetic_dataset
