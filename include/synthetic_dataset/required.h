#pragma once

#include <optional>
#include <utility>

namespace synthetic_dataset {
inline namespace v2 {

/// @throws Error saying what was asked for and which requirement would have it computed
[[noreturn]] void throwNotRequired(const char* name, const char* requirement);

/// A value that is computed only if a writer's requirements ask for it. Reading it otherwise
/// throws, so that an unknown value cannot be mistaken for an empty one.
template <class T>
class Required {
 public:
  /// @param name  the value's name, for the message: "Scene::depth"
  /// @param requirement  the member of Requirements that asks for it: "depth"
  Required(const char* name, const char* requirement) : name_(name), requirement_(requirement) {}

  /// The computed value.
  /// @throws Error if no writer of the run requires it
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
