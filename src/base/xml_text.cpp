#include "base/xml_text.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace synthetic_dataset::base {
namespace {

constexpr int kMostAttributes = 1000;

/// Walks over a text as tinyxml2 does, and counts the attributes of each element.
class AttributeCounter {
 public:
  explicit AttributeCounter(std::string_view text) : text_(text) {}

  /// The line of the first element that has too many, from 1; 0 where none has.
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

  /// Of the element that begins here; goes on behind it.
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

}  // namespace

std::string XmlFault::text() const {
  return (line > 0 ? "line " + std::to_string(line) + ": " : "") + "cannot be read as XML (" +
         reason + ")";
}

std::optional<XmlFault> parseXml(tinyxml2::XMLDocument& document, const std::string& text) {
  if (const int line = AttributeCounter(text).lineWithTooMany(); line > 0) {
    return XmlFault{line, "an element has more than 1000 attributes"};
  }
  if (document.Parse(text.c_str(), text.size()) == tinyxml2::XML_SUCCESS) return std::nullopt;
  return XmlFault{document.ErrorLineNum(), document.ErrorName()};
}

}  // namespace synthetic_dataset::base
