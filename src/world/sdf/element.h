#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <tinyxml2.h>

#include "world/sdf/sdf_file.h"

namespace synthetic_dataset::world {

/// An XML element of a file, or none, which has neither text nor children.
class Element {
 public:
  Element() = default;
  Element(const tinyxml2::XMLElement* xml, const SdfFile* file) : xml_(xml), file_(file) {}

  explicit operator bool() const { return xml_ != nullptr; }

  [[nodiscard]] std::string name() const { return xml_ != nullptr ? xml_->Name() : ""; }

  /// Its own text without the blanks around it, comments left out.
  [[nodiscard]] std::string text() const;

  /// An empty text if there is none.
  [[nodiscard]] std::string attribute(const char* name) const;
  [[nodiscard]] bool hasAttribute(const char* name) const;

  [[nodiscard]] bool has(const char* name) const { return static_cast<bool>(child(name)); }

  /// The first child of that name.
  [[nodiscard]] Element child(const char* name) const;
  [[nodiscard]] Element firstChild() const;
  [[nodiscard]] std::vector<Element> children(const char* name) const;
  [[nodiscard]] std::vector<Element> children() const;

  /// A value in SDF's sense: the text of a child element. SDF 1.0 wrote it as an attribute of this
  /// element, or of the child (`rgba`, `xyz`, `pose`, `enabled`, `angle`, `link`).
  /// @return nothing if the file does not give it
  [[nodiscard]] std::optional<std::string> value(const char* name) const;

  /// 0 for none.
  [[nodiscard]] int line() const { return xml_ != nullptr ? xml_->GetLineNum() : 0; }

  /// The line of a child, or of this element if it has no child of that name.
  [[nodiscard]] int lineOf(const char* name) const;

  [[nodiscard]] const SdfFile& file() const { return *file_; }

  /// The folder to which URIs are relative.
  [[nodiscard]] std::filesystem::path folder() const { return file_->path.parent_path(); }

 private:
  const tinyxml2::XMLElement* xml_ = nullptr;
  const SdfFile* file_ = nullptr;
};

}  // namespace synthetic_dataset::world
