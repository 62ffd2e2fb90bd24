#pragma once

#include <optional>
#include <string>

#include <tinyxml2.h>

namespace synthetic_dataset::base {

/// Why a text cannot be read as XML.
struct XmlFault {
  int line = 0;        ///< 0 if there is none
  std::string reason;  ///< "XML_ERROR_PARSING_TEXT"

  /// "line 3: cannot be read as XML (XML_ERROR_PARSING_TEXT)"
  [[nodiscard]] std::string text() const;
};

/// Reads XML. All XML is read through this function, as the text may be untrusted. An element with
/// more than 1000 attributes is refused, since tinyxml2 compares each attribute with all before it.
/// Entities that the text's own DOCTYPE defines are expanded.
/// @return nullopt if `document` contains the text
[[nodiscard]] std::optional<XmlFault> parseXml(tinyxml2::XMLDocument& document,
                                               const std::string& text);

}  // namespace synthetic_dataset::base
