#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/yaml_text/yaml_edit.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Where a text stops being YAML.
struct TextFault {
  std::string message;
  std::int64_t line = 0;  ///< from 1; 0: not known
};

/// A settings file as it is edited: its text, which is its whole state, and the earlier ones. Every
/// change is on the disk, as a whole, before the call returns. What somebody else writes to the
/// file is noticed by its content, and nothing is written over it before the user has decided.
class SettingsDocument {
 public:
  /// @param file  that is there
  explicit SettingsDocument(std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::int64_t revision() const { return revision_; }
  [[nodiscard]] bool canUndo() const { return !past_.empty(); }
  [[nodiscard]] bool canRedo() const { return !future_.empty(); }
  [[nodiscard]] const std::optional<TextFault>& fault() const { return fault_; }

  /// The text that somebody else has put in the file; empty where the file is gone.
  [[nodiscard]] const std::optional<std::string>& outside() const { return outside_; }

  /// What the text says, without substitutions and included files; the last time that it was YAML.
  /// An angle is the text that it is written as: "deg(20)".
  [[nodiscard]] const Value& settings() const { return settings_; }

  /// Changes values, all of them or none. Paths may name `yolo/main_list` as `main_list` in `yolo`.
  /// @param step  changes of one name, not empty, are undone together
  /// @throws HttpError 409 when the revision is not the current one, or somebody else has changed
  ///     the file; Error when the text does not take a change
  void change(std::int64_t revision, const std::vector<base::YamlChange>& changes,
              const std::string& step);

  /// Takes a text that was typed. One that is no YAML is kept, but not written.
  void type(std::int64_t revision, const std::string& text, const std::string& step);

  void undo();
  void redo();

  /// Looks whether somebody else has changed the file.
  /// @return whether what outside() says has changed
  bool look();

  /// Ends what outside() says: their text is taken, as a change that can be undone, or this one
  /// written over it.
  void takeOutside();
  void keepOwn();

 private:
  struct Earlier {
    std::string text;
    std::string step;  ///< that led away from it
  };

  void requireCurrent(std::int64_t revision);
  void requireNobodyElse();
  void show(const std::string& text);
  void record(const std::string& step);
  void moveTo(std::vector<Earlier>& from, std::vector<Earlier>& to);
  void write();
  [[nodiscard]] std::optional<std::string> onDisk() const;

  std::string file_;
  std::string text_;
  std::optional<std::string> written_;  ///< what the file holds, as far as this knows
  std::optional<std::string> outside_;
  std::optional<TextFault> fault_;
  Value settings_;
  std::int64_t revision_ = 1;
  std::vector<Earlier> past_;
  std::vector<Earlier> future_;
};

/// Gives a file a new content, so that it has the old one or the new one at any time, whatever
/// happens. It keeps its permissions; a symbolic link stays one.
/// @throws Error when it cannot be written
void writeWhole(const std::string& file, const std::string& content);

}  // namespace synthetic_dataset::programs
