#pragma once

#include <cstddef>
#include <string>

namespace synthetic_dataset::base {

/// Steps through a YAML text from places that a parser has found. All places are byte offsets; the
/// text's size means its end.
class YamlScan {
 public:
  /// @param text  must outlive this object
  explicit YamlScan(const std::string& text) : text_(text) {}

  /// The line that contains the offset: its begin, its end before the line break, and where the
  /// next line begins.
  [[nodiscard]] std::size_t lineBegin(std::size_t offset) const;
  [[nodiscard]] std::size_t lineEnd(std::size_t offset) const;
  [[nodiscard]] std::size_t nextLine(std::size_t offset) const;
  [[nodiscard]] std::size_t column(std::size_t offset) const { return offset - lineBegin(offset); }

  /// The offset after spaces, line breaks, comments and the characters in `more`.
  [[nodiscard]] std::size_t afterGap(std::size_t offset, const std::string& more) const;

  /// The offset after anchors and tags, and the gap that follows them.
  [[nodiscard]] std::size_t afterProperties(std::size_t offset) const;

  /// The offset after a word, such as an alias.
  [[nodiscard]] std::size_t wordEnd(std::size_t offset) const;

  /// The offset after the last word of a line, without its comment.
  [[nodiscard]] std::size_t lineOfWordsEnd(std::size_t offset) const;

  /// The offset after a name in a map.
  [[nodiscard]] std::size_t nameEnd(std::size_t offset, bool in_flow) const;

  /// The offset of this character if it precedes the offset with only spaces between them; else the
  /// offset itself.
  [[nodiscard]] std::size_t markBefore(std::size_t offset, char mark) const;

  /// The offset after a scalar.
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
