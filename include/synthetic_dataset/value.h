#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// A parameter's value: a typed tree, as in the ROS parameter server and in YAML.
class Value {
 public:
  using List = std::vector<Value>;
  using Map = std::map<std::string, Value>;

  Value() = default;  ///< nothing (YAML's null)
  Value(bool value) : data_(value) {}
  Value(int value) : data_(static_cast<std::int64_t>(value)) {}
  Value(std::int64_t value) : data_(value) {}
  Value(double value) : data_(value) {}
  Value(const char* value) : data_(std::string(value)) {}
  Value(std::string value) : data_(std::move(value)) {}
  Value(List value) : data_(std::move(value)) {}
  Value(Map value) : data_(std::move(value)) {}

  template <class T>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<T>(data_);
  }

  /// The content if it has this type, else nullptr.
  template <class T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&data_);
  }
  template <class T>
  [[nodiscard]] T* as() {
    return std::get_if<T>(&data_);
  }

  [[nodiscard]] bool isNull() const { return std::holds_alternative<std::monostate>(data_); }

  /// A scalar as Python's `str()` prints it (`3`, `2.5`, `1.0`, `True`, `fork lift`), which is how
  /// class and id enter label files; lists and maps in YAML's flow style, for messages.
  [[nodiscard]] std::string text() const;

  /// The kind of value, for messages: "a number", "a list", "nothing", ...
  [[nodiscard]] std::string kind() const;

  friend bool operator==(const Value& a, const Value& b) { return a.data_ == b.data_; }
  friend bool operator!=(const Value& a, const Value& b) { return !(a == b); }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Map> data_;
};

}  // namespace v2
}  // namespace synthetic_dataset
