#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
#include "world/world_options.h"

namespace synthetic_dataset::world {

/// Where something is in a file, for messages: "world.sdf: line 12: model 'shelf': link 'body'".
class SourceLocation {
 public:
  SourceLocation() = default;  ///< of something that is in no file
  explicit SourceLocation(std::string file) : file_(std::move(file)) {}

  /// The location of an element below this one.
  [[nodiscard]] SourceLocation in(const std::string& kind, const std::string& name) const {
    SourceLocation inner = *this;
    inner.path_ += kind + " '" + name + "': ";
    return inner;
  }

  /// The location of an element of which there is only one: "scene: fog: ".
  [[nodiscard]] SourceLocation in(const std::string& kind) const {
    SourceLocation inner = *this;
    inner.path_ += kind + ": ";
    return inner;
  }

  /// The same path in another file, for the elements of an included one; an empty name changes
  /// nothing.
  [[nodiscard]] SourceLocation inFile(const std::string& file) const {
    SourceLocation other = *this;
    if (!file.empty()) other.file_ = file;
    return other;
  }

  /// The same location with a line number for messages; 0 for none.
  [[nodiscard]] SourceLocation atLine(int line) const {
    SourceLocation other = *this;
    other.line_ = line;
    return other;
  }

  /// "world.sdf: line 12: model 'shelf': ", to begin a message.
  [[nodiscard]] std::string prefix() const {
    const std::string line = line_ > 0 ? "line " + std::to_string(line_) + ": " : "";
    return (file_.empty() ? "" : file_ + ": ") + line + path_;
  }

  [[nodiscard]] std::string message(const std::string& text) const { return prefix() + text; }

 private:
  std::string file_;
  int line_ = 0;
  std::string path_;
};

/// The errors of a world or model that lacks files.
class MissingAssets : public ErrorList {
 public:
  MissingAssets(std::vector<std::string> messages, std::size_t count)
      : ErrorList(std::move(messages)), count_(count) {}

  /// How many different files are missing or cannot be read.
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  std::size_t count_;
};

/// The errors and notes that came up while files were read, each once, in order of appearance.
struct Findings {
  std::vector<std::string> errors;
  std::vector<std::string> notes;  ///< what was left out or replaced
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;

  void addError(const std::string& message);
  void addNote(const std::string& message);

  /// Adds a remark. If it applies to several places, it is listed once, with the first place and
  /// how often it applies.
  void addNote(const SourceLocation& location, const std::string& remark);

  /// Adds something that is missing or unreadable: an error, or a note that it is left out.
  /// Something that is missing in several places ("mesh 'x.dae': no such file; looked in ...") is
  /// listed once, with how often it is wanted, and the list of searched folders is not repeated for
  /// the next file.
  void addMissing(const SourceLocation& location, const std::string& thing);
  void addMissing(const std::string& thing);

  /// @throws ErrorList with all errors, if there are any; MissingAssets if files are missing
  void throwErrors() const;

 private:
  /// A remark and the places to which it applies.
  struct Remark {
    std::string message;    ///< with the place where it was found first
    std::size_t index = 0;  ///< in the list
    std::set<std::string> locations;
    std::vector<std::string> models;  ///< further models to which it applies: "model 'b'"
  };

  using Remarks = std::map<std::string, Remark>;

  void add(const std::string& location, const std::string& text, const char* times,
           const std::string& end, Remarks& known, std::vector<std::string>& list);
  [[nodiscard]] std::string shortened(const std::string& thing);

  Remarks missing_;
  Remarks noted_;
  std::vector<std::string> searches_;  ///< the "looked in ..." texts that were listed
};

}  // namespace synthetic_dataset::world
