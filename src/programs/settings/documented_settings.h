#pragma once

#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A setting as a commented settings file shows it.
struct DocumentedSetting {
  std::string path;         ///< "camera/effects/blur"; entries of a list are "motions/-/name"
  std::string description;  ///< the comment above it, in one line
  std::string unit;         ///< what stands in brackets behind its value: "m/s"; or empty
  std::string text;         ///< its value in YAML; empty: a group
  Value value;              ///< the same
  bool is_active = false;   ///< not commented out, so that the value is its default or an example
                            ///< of what is required

  [[nodiscard]] bool isRequired() const { return description.rfind("REQUIRED", 0) == 0; }
};

/// The settings of a file in which those that are left out stand behind a `#`: where the file would
/// be YAML with the `# ` removed before a name and a colon.
[[nodiscard]] std::vector<DocumentedSetting> documentedSettings(const std::string& text);

/// config/params.yaml as it was when this program was built.
[[nodiscard]] const std::string& settingsDocument();

/// The settings of config/params.yaml.
[[nodiscard]] const std::vector<DocumentedSetting>& documentedSettings();

/// What the settings' readers declare of those of config/params.yaml, by path: Parameters has the
/// facts' names.
[[nodiscard]] std::map<std::string, Value::Map> declaredSettings();

/// A JSON schema (draft 7) of settings files, for editors: what each setting means, and which names
/// there are. Names of objects, writers and cameras are free.
[[nodiscard]] Value settingsSchema();

}  // namespace synthetic_dataset::programs
