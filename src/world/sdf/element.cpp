#include "world/sdf/element.h"

#include "world/files/text.h"

namespace synthetic_dataset::world {

std::string Element::text() const {
  std::string result;
  if (xml_ == nullptr) return result;
  for (const auto* node = xml_->FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) result += node->Value();
  }
  return trimmed(result);
}

std::string Element::attribute(const char* name) const {
  const char* text = xml_ != nullptr ? xml_->Attribute(name) : nullptr;
  return text != nullptr ? text : "";
}

bool Element::hasAttribute(const char* name) const {
  return xml_ != nullptr && xml_->Attribute(name) != nullptr;
}

Element Element::child(const char* name) const {
  if (xml_ == nullptr) return {};
  return {xml_->FirstChildElement(name), file_};
}

Element Element::firstChild() const { return child(nullptr); }

std::vector<Element> Element::children(const char* name) const {
  std::vector<Element> result;
  if (xml_ == nullptr) return result;
  for (const auto* each = xml_->FirstChildElement(name); each != nullptr;
       each = each->NextSiblingElement(name)) {
    result.emplace_back(each, file_);
  }
  return result;
}

std::vector<Element> Element::children() const { return children(nullptr); }

std::optional<std::string> Element::value(const char* name) const {
  const Element element = child(name);
  if (!element) {
    if (hasAttribute(name)) return attribute(name);
    return std::nullopt;
  }
  for (const char* old : {"rgba", "xyz", "pose", "enabled", "angle", "link"}) {
    if (element.hasAttribute(old)) return element.attribute(old);
  }
  return element.text();
}

int Element::lineOf(const char* name) const {
  const Element element = child(name);
  return element ? element.line() : line();
}

}  // namespace synthetic_dataset::world
