#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/yaml_text/yaml_edit.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The place where a text stops being valid YAML.
struct TextFault {
  std::string message;
  std::int64_t line = 0;  ///< from 1; 0: not known
};

/// A settings file that is being edited: its text, which is its whole state, and earlier texts.
/// Every change is on the disk, as a whole, before the call returns. What somebody else writes to
/// the file is noticed by its content, and is not overwritten before the user has decided.
class SettingsDocument {
 public:
  /// @param file  one that exists
  explicit SettingsDocument(std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::int64_t revision() const { return revision_; }
  [[nodiscard]] bool canUndo() const { return !past_.empty(); }
  [[nodiscard]] bool canRedo() const { return !future_.empty(); }
  [[nodiscard]] const std::optional<TextFault>& fault() const { return fault_; }

  /// The text that somebody else has put in the file, if any; an empty text if the file is gone.
  [[nodiscard]] const std::optional<std::string>& outside() const { return outside_; }

  /// The settings in the last text that was valid YAML, without substitutions and included files.
  /// An angle such as "deg(20)" stays a text.
  [[nodiscard]] const Value& settings() const { return settings_; }

  /// Changes values, all of them or none. Paths may name `yolo/main_list` as `main_list` in `yolo`.
  /// @param step  successive changes with the same name are undone together, unless it is empty
  /// @throws HttpError 409 when the revision is not the current one, or somebody else has changed
  ///     the file; Error when the text cannot be edited that way
  void change(std::int64_t revision, const std::vector<base::YamlChange>& changes,
              const std::string& step);

  /// Takes a text that was typed. One that is not valid YAML is kept, but not written.
  void type(std::int64_t revision, const std::string& text, const std::string& step);

  void undo();
  void redo();

  /// Checks whether somebody else has changed the file.
  /// @return whether the value of outside() has changed
  bool look();

  /// Resolve outside(): take the other text, as a change that can be undone, or overwrite it with
  /// this one.
  void acceptExternal();
  void overwriteExternal();

 private:
  struct Earlier {
    std::string text;
    std::string step;  ///< the step that led away from the text
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
  std::optional<std::string> written_;  ///< the file's content, as far as known
  std::optional<std::string> outside_;
  std::optional<TextFault> fault_;
  Value settings_;
  std::int64_t revision_ = 1;
  std::vector<Earlier> past_;
  std::vector<Earlier> future_;
};

/// Replaces a file's content, so that it has the old one or the new one at any time, whatever
/// happens. The file keeps its permissions; a symbolic link stays one.
/// @throws Error when it cannot be written
void writeWhole(const std::string& file, const std::string& content);

}  // namespace synthetic_dataset::programs
