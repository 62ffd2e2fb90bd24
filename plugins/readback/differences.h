#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// Comparing what files hold with what they should hold, value by value.
///
/// `other` is a second version of what is right, or null: where the two differ, nobody knows what
/// is right, and any value will do.
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

/// Compares a tree of JSON with the right one: the same members, entries and values. Whole numbers
/// are to be equal, other numbers near.
void compareJson(const nlohmann::json& found, const nlohmann::json& right, const std::string& where,
                 Differences& differences, const nlohmann::json* other = nullptr);

/// Compares texts line by line and word by word; words end at blanks and at punctuation marks.
/// Words that have decimals in the right text may differ by one in the last of them, or by 1e-6
/// where they have many; what is no number is to be equal.
void compareText(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences, const std::string* other = nullptr);

/// Compares the contents of files in the way that their name asks for: JSON, NumPy arrays of
/// doubles, other bytes, which are to be equal, or text.
/// @param name  of the file, for the lines
void compareContents(const std::string& found, const std::string& right, const std::string& name,
                     Differences& differences, const std::string* other = nullptr);

/// Whether it has no bytes but those of letters, digits, marks and blanks.
[[nodiscard]] bool isText(const std::string& bytes);

/// Compares what writers keep in the manifest: as text or, where it is none, as bytes, in which
/// numbers of 64 bits may be near.
void compareRecords(const std::string& found, const std::string& right, const std::string& where,
                    Differences& differences, const std::string* other = nullptr);

}  // namespace synthetic_dataset::formats
