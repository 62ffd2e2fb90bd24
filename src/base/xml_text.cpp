#include "base/xml_text.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <sstream>
#include <string_view>

namespace synthetic_dataset::base {
namespace {

constexpr int kMostAttributes = 1000;

/// Scans a text as tinyxml2 does, and counts the attributes of each element.
class AttributeCounter {
 public:
  explicit AttributeCounter(std::string_view text) : text_(text) {}

  /// The line of the first element that has too many attributes, from 1; 0 if none has.
  int lineWithTooMany() {
    for (at_ = text_.find('<'); at_ < text_.size(); at_ = text_.find('<', at_)) {
      const std::size_t begin = at_;
      if (skip("<?", "?>") || skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<!", ">")) {
        continue;
      }
      if (attributes() > kMostAttributes) {
        const std::string_view before = text_.substr(0, begin);
        return 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
      }
    }
    return 0;
  }

 private:
  bool skip(std::string_view start, std::string_view end) {
    if (text_.substr(at_, start.size()) != start) return false;
    const std::size_t last = text_.find(end, at_ + start.size());
    at_ = last == std::string_view::npos ? text_.size() : last + end.size();
    return true;
  }

  /// Counts the attributes of the element that begins at the current position; moves to its end.
  int attributes() {
    int count = 0;
    for (++at_; at_ < text_.size() && text_[at_] != '>'; ++at_) {
      const char c = text_[at_];
      if (c != '"' && c != '\'') continue;
      ++count;  // an attribute has one value in quotes
      at_ = std::min(text_.find(c, at_ + 1), text_.size());
    }
    return count;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// A document type declaration and its entities, which tinyxml2 does not support: those in the text
/// itself are expanded, but not entities inside them, so that nested ones cannot grow
/// exponentially.
class DocumentType {
 public:
  explicit DocumentType(const std::string& text) : text_(text), begin_(text.find('<')) {
    // Only declarations and comments precede the root element.
    while (begin_ < text.size() && text.compare(begin_, kKeyword.size(), kKeyword) != 0) {
      const char next = begin_ + 1 < text.size() ? text[begin_ + 1] : '\0';
      const bool is_before_root = next == '?' || next == '!';
      begin_ = is_before_root ? text.find('<', begin_ + 1) : std::string::npos;
    }
  }

  [[nodiscard]] bool isThere() const { return begin_ < text_.size(); }

  /// The text without the declaration and with its entities expanded; lines keep their numbers.
  [[nodiscard]] std::string taken() {
    const std::size_t end = findEnd();
    std::string result = text_;
    for (std::size_t i = begin_; i < end; ++i) {
      if (result[i] != '\n') result[i] = ' ';
    }
    readEntities(text_.substr(begin_, end - begin_));
    for (std::size_t at = result.find('&', end); at != std::string::npos;
         at = result.find('&', at)) {
      const std::size_t last = result.find(';', at);
      const auto entity = last == std::string::npos
                              ? entities_.end()
                              : entities_.find(result.substr(at + 1, last - at - 1));
      if (entity == entities_.end()) {
        ++at;
        continue;
      }
      result.replace(at, last + 1 - at, entity->second);
      at += entity->second.size();
      if (result.size() > kMostGrowth + text_.size()) return text_;  // which is then refused
    }
    return result;
  }

 private:
  static constexpr std::string_view kKeyword = "<!DOCTYPE";
  static constexpr std::size_t kMostGrowth = 10000000;  // [byte]

  /// The position after the first `>` that is not in brackets or quotes.
  [[nodiscard]] std::size_t findEnd() const {
    int depth = 0;
    for (std::size_t i = begin_; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '"' || c == '\'') {
        i = std::min(text_.find(c, i + 1), text_.size());
      } else if (c == '[') {
        ++depth;
      } else if (c == ']') {
        --depth;
      } else if (c == '>' && depth <= 0) {
        return i + 1;
      }
    }
    return text_.size();
  }

  /// Reads `<!ENTITY name "text">`; entities in other files are ignored.
  void readEntities(const std::string& type) {
    const std::string keyword = "<!ENTITY";
    for (std::size_t at = type.find(keyword); at != std::string::npos;
         at = type.find(keyword, at + 1)) {
      const std::size_t end = std::min(type.find('>', at), type.size());
      std::istringstream words(type.substr(at + keyword.size(), end - at - keyword.size()));
      std::string name;
      char quote = 0;
      std::string value;
      if (!(words >> name >> quote) || (quote != '"' && quote != '\'')) continue;
      std::getline(words, value, quote);
      entities_.emplace(name, value);
    }
  }

  const std::string& text_;
  std::size_t begin_;
  std::map<std::string, std::string> entities_;
};

}  // namespace

std::string XmlFault::text() const {
  return (line > 0 ? "line " + std::to_string(line) + ": " : "") + "cannot be read as XML (" +
         reason + ")";
}

std::optional<XmlFault> parseXml(tinyxml2::XMLDocument& document, const std::string& given) {
  DocumentType type(given);
  const std::string taken = type.isThere() ? type.taken() : "";
  const std::string& text = type.isThere() ? taken : given;
  if (const int line = AttributeCounter(text).lineWithTooMany(); line > 0) {
    return XmlFault{line, "an element has more than 1000 attributes"};
  }
  if (document.Parse(text.c_str(), text.size()) == tinyxml2::XML_SUCCESS) return std::nullopt;
  return XmlFault{document.ErrorLineNum(), document.ErrorName()};
}

}  // namespace synthetic_dataset::base
