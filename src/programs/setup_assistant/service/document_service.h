#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "config/launch_substitution.h"
#include "programs/setup_assistant/document/settings_document.h"
#include "programs/setup_assistant/folders/allowed_folders.h"
#include "run/setup/package_index.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The settings of a file together with those that it includes, with substitutions filled in.
struct EffectiveSettings {
  std::int64_t revision = 0;
  std::optional<Value> settings;    ///< of the run, or of the first run of a twin
  std::vector<std::string> errors;  ///< if there are no settings, the reasons
};

/// The settings document for many pages at once, and their requests about it.
class DocumentService {
 public:
  /// Called after each change, in the thread that made it.
  using OnChange = std::function<void()>;

  /// @param file  one that exists
  /// @param allowed  the folders in which included files may lie
  DocumentService(std::string file, const AllowedFolders& allowed, OnChange on_change);

  [[nodiscard]] const std::string& file() const { return document_.file(); }

  /// All that a page is told about the document.
  [[nodiscard]] Value state();

  /// Carry out a page's requests. @param body  of the request
  [[nodiscard]] Value set(const Value& body);
  [[nodiscard]] Value type(const Value& body);
  [[nodiscard]] Value undo();
  [[nodiscard]] Value redo();
  [[nodiscard]] Value decideOutside(const Value& body);

  /// @throws HttpError 409 when the file on the disk does not say what the page shows
  void requireOnDisk();

  /// Checks whether somebody else has changed the file.
  void look();

  [[nodiscard]] std::int64_t revision();

  /// The effective settings of the last text that was valid YAML.
  [[nodiscard]] EffectiveSettings effective();

 private:
  template <class Work>
  Value changing(const Work& work);
  [[nodiscard]] Value stateLocked();
  void readEffective();
  [[nodiscard]] Value load(const config::TextFinder& environment) const;
  void rememberVariables();
  [[nodiscard]] std::optional<std::string> variable(const std::string& name) const;

  std::mutex mutex_;
  SettingsDocument document_;
  const AllowedFolders& allowed_;
  std::set<std::string> variables_;  ///< environment variables that the settings named at the start
  EffectiveSettings effective_;
  run::RosPackageIndex packages_;  ///< found once, since every change asks for them
  OnChange on_change_;
};

}  // namespace synthetic_dataset::programs
