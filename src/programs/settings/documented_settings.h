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
  std::string unit;         ///< the text in brackets after its value, such as "m/s"; or empty
  std::string text;         ///< its value in YAML; empty: a group
  Value value;              ///< the same, parsed
  bool is_active = false;   ///< not commented out, so that the value is its default or an example
                            ///< of what is required

  [[nodiscard]] bool isRequired() const { return description.rfind("REQUIRED", 0) == 0; }
};

/// Reads the settings of a file, including those that are commented out: lines that are YAML once
/// the `# ` before a name and a colon is removed.
[[nodiscard]] std::vector<DocumentedSetting> documentedSettings(const std::string& text);

/// config/params.yaml as it was when this program was built.
[[nodiscard]] const std::string& settingsDocument();

/// The settings of config/params.yaml.
[[nodiscard]] const std::vector<DocumentedSetting>& documentedSettings();

/// The facts that the readers declare about the settings of config/params.yaml, by path; their
/// names are those of Parameters.
[[nodiscard]] std::map<std::string, Value::Map> declaredSettings();

/// A JSON schema (draft 7) of settings files, for editors: the meaning of each setting, and the
/// names that exist. Objects, writers and cameras may have any name.
[[nodiscard]] Value settingsSchema();

}  // namespace synthetic_dataset::programs
