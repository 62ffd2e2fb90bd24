#pragma once

#include <cstddef>
#include <string>

namespace synthetic_dataset::base {

/// Steps through a YAML text from places that a parser has found. All are offsets in bytes; the
/// text's size is the end.
class YamlScan {
 public:
  /// @param text  has to outlive this
  explicit YamlScan(const std::string& text) : text_(text) {}

  /// The line that holds the offset: its begin, its end before the line break, and where the next
  /// one begins.
  [[nodiscard]] std::size_t lineBegin(std::size_t offset) const;
  [[nodiscard]] std::size_t lineEnd(std::size_t offset) const;
  [[nodiscard]] std::size_t nextLine(std::size_t offset) const;
  [[nodiscard]] std::size_t column(std::size_t offset) const { return offset - lineBegin(offset); }

  /// Behind spaces, line breaks, comments and these characters.
  [[nodiscard]] std::size_t afterGap(std::size_t offset, const std::string& more) const;

  /// Behind anchors and tags, and what follows them until there is something.
  [[nodiscard]] std::size_t afterProperties(std::size_t offset) const;

  /// Behind a word: an alias.
  [[nodiscard]] std::size_t wordEnd(std::size_t offset) const;

  /// Behind the last word of a line, without its comment.
  [[nodiscard]] std::size_t lineOfWordsEnd(std::size_t offset) const;

  /// Behind a map's name.
  [[nodiscard]] std::size_t nameEnd(std::size_t offset, bool in_flow) const;

  /// Where this character stands before the offset in its line, with spaces alone between; the
  /// offset itself where it does not.
  [[nodiscard]] std::size_t markBefore(std::size_t offset, char mark) const;

  /// Behind a scalar.
  /// @param indentation  of the block list or map that it is in
  [[nodiscard]] std::size_t scalarEnd(std::size_t offset, std::ptrdiff_t indentation,
                                      bool in_flow) const;

 private:
  enum class Place { kName, kBlock, kFlow };

  [[nodiscard]] bool isAt(std::size_t offset, const char* characters) const;
  [[nodiscard]] std::size_t quotedEnd(std::size_t offset) const;
  [[nodiscard]] std::size_t literalEnd(std::size_t offset, std::ptrdiff_t indentation) const;
  [[nodiscard]] std::size_t plainEnd(std::size_t offset, std::ptrdiff_t indentation,
                                     Place place) const;
  [[nodiscard]] bool endsPlain(std::size_t offset, Place place, bool in_flow_name) const;
  [[nodiscard]] std::size_t withoutSpaces(std::size_t begin, std::size_t end) const;

  const std::string& text_;
};

}  // namespace synthetic_dataset::base
