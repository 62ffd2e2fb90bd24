#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// Comparing what files hold with what they should hold, value by value.
namespace synthetic_dataset::formats {

/// What differs, a line each; of many, the first few and their number.
class Differences {
 public:
  /// @param where  in which file, and where in it
  void add(const std::string& where, const std::string& found, const std::string& right);

  /// The same with a sentence.
  void add(const std::string& line);

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

/// Whether a number is the other one but for what is lost in text and in sums.
[[nodiscard]] bool areNear(double found, double right);

/// Compares a tree of JSON with the right one: the same members, entries and values. Whole numbers
/// are to be equal, other numbers near.
void compareJson(const nlohmann::json& found, const nlohmann::json& right, const std::string& where,
                 Differences& differences);

/// Compares texts line by line and word by word. Words that have decimals in the right text may
/// differ by one in the last of them; what is no number is to be equal.
void compareText(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences);

}  // namespace synthetic_dataset::formats
