#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"
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

/// What reading files has brought to light, each thing once, in the order of its finding.
struct Findings {
  std::vector<std::string> errors;
  std::vector<std::string> notes;  ///< what was left out or replaced
  OnMissingAsset on_missing_asset = OnMissingAsset::kError;

  void addError(const std::string& message);
  void addNote(const std::string& message);

  /// Something that cannot be had: an error, or a note that it is left out. A file that is missing
  /// in several places ("<place>: mesh 'x.dae': no such file; looked in ...") is listed once, with
  /// how often it is wanted, and where it was looked for is not repeated for the next file.
  void addMissing(const std::string& message);

  /// @throws ErrorList with all errors, if there are any; MissingAssets if files are missing
  void throwErrors() const;

 private:
  /// A file that is missing, and the messages that it takes part in.
  struct Missing {
    std::string thing;                ///< "mesh 'x.dae': no such file; looked in ..."
    std::string message;              ///< where it was found first
    std::size_t index = 0;            ///< in errors or notes
    std::set<std::string> messages;   ///< of all places where it is wanted
    std::vector<std::string> models;  ///< that want it, too: "model 'b'"
  };

  [[nodiscard]] std::vector<std::string>& missingList();
  [[nodiscard]] std::string shortened(const std::string& message);
  void countAgain(Missing& missing, const std::string& message);

  std::vector<Missing> missing_;
  std::vector<std::string> searches_;  ///< "looked in ...", as they were listed
};

}  // namespace synthetic_dataset::world
