#pragma once

#include <string>
#include <utility>
#include <vector>

#include "world/load_options.h"

namespace synthetic_dataset::world {

/// Where in which file something stands, for messages: "world.sdf: line 12: model
/// 'shelf': link 'body'".
class Place {
 public:
  explicit Place(std::string file) : file_(std::move(file)) {}

  /// The place of an element below this one.
  [[nodiscard]] Place in(const std::string& kind, const std::string& name) const {
    Place inner = *this;
    inner.path_ += kind + " '" + name + "': ";
    return inner;
  }

  /// The place of an element of which there is but one: "scene: fog: ".
  [[nodiscard]] Place in(const std::string& kind) const {
    Place inner = *this;
    inner.path_ += kind + ": ";
    return inner;
  }

  /// The same path in another file, for the elements of an included one; an empty name changes
  /// nothing.
  [[nodiscard]] Place inFile(const std::string& file) const {
    Place other = *this;
    if (!file.empty()) other.file_ = file;
    return other;
  }

  /// The same place with the line that a message names; 0 for none.
  [[nodiscard]] Place atLine(int line) const {
    Place other = *this;
    other.line_ = line;
    return other;
  }

  [[nodiscard]] std::string message(const std::string& text) const {
    const std::string line = line_ > 0 ? "line " + std::to_string(line_) + ": " : "";
    return file_ + ": " + line + path_ + text;
  }

 private:
  std::string file_;
  int line_ = 0;
  std::string path_;
};

/// What reading files has brought to light, each thing once, in the order of its finding.
struct Findings {
  std::vector<std::string> errors;
  std::vector<std::string> notes;  ///< what was left out or replaced
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;

  void addError(const std::string& message);
  void addNote(const std::string& message);

  /// Something that cannot be had: an error, or a note that it is left out.
  void addMissing(const std::string& message);

  /// @throws ErrorList with all errors, if there are any
  void throwErrors() const;
};

}  // namespace synthetic_dataset::world
