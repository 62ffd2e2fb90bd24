#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// Compares the content of files with the expected content, value by value.
///
/// `other` is a second version of the expected content, or null: where the two differ, the right
/// value is unknown and any value is accepted.
namespace synthetic_dataset::formats {

/// The differences, one per line; if there are many, the first few and their number.
class Differences {
 public:
  /// @param where  the file, and the place in it
  void add(const std::string& where, const std::string& found, const std::string& right);

  /// Adds a difference as a sentence.
  void add(const std::string& line);

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  std::vector<std::string> lines_;
  std::size_t count_ = 0;
};

/// Compares a JSON tree with the expected one: the same members, entries and values. Integers must
/// be equal, other numbers close.
void compareJson(const nlohmann::json& found, const nlohmann::json& right, const std::string& where,
                 Differences& differences, const nlohmann::json* other = nullptr);

/// Compares texts line by line and word by word; words end at blanks and punctuation marks. Words
/// with decimals in the expected text may differ by one in the last decimal, or by 1e-6 if they
/// have many; words that are not numbers must be equal.
void compareText(const std::string& found, const std::string& right, const std::string& where,
                 Differences& differences, const std::string* other = nullptr);

/// Compares the contents of files according to their name: as JSON, NumPy arrays of doubles, text,
/// or other bytes, which must be equal.
/// @param name  of the file, for messages
void compareContents(const std::string& found, const std::string& right, const std::string& name,
                     Differences& differences, const std::string* other = nullptr);

/// Whether it has no control characters except line ends and tabs.
[[nodiscard]] bool isText(const std::string& bytes);

/// Compares the records that writers keep in the manifest: as text or, if they are not text, as
/// bytes, in which 64-bit numbers need only be close.
void compareRecords(const std::string& found, const std::string& right, const std::string& where,
                    Differences& differences, const std::string* other = nullptr);

}  // namespace synthetic_dataset::formats
