#pragma once

#include <string>
#include <vector>

#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// A setting as a commented settings file shows it.
struct DocumentedSetting {
  std::string path;         ///< "camera/effects/blur"; entries of a list are "motions/-/name"
  std::string description;  ///< the comment above it, in one line
  std::string value;        ///< in YAML; empty: a group
  bool is_active = false;   ///< not commented out, so that the value is its default or an example
                            ///< of what is required

  [[nodiscard]] bool isRequired() const { return description.rfind("REQUIRED", 0) == 0; }
};

/// The settings of a file in which those that are left out stand behind a `#`: where the file would
/// be YAML with the `# ` removed before a name and a colon.
[[nodiscard]] std::vector<DocumentedSetting> documentedSettings(const std::string& text);

/// config/params.yaml as it was when this program was built.
[[nodiscard]] const std::string& settingsDocument();

/// A JSON schema (draft 7) of settings files, for editors: what each setting means, and which names
/// there are. Names of objects, writers and cameras are free.
[[nodiscard]] Value settingsSchema(const std::vector<DocumentedSetting>& settings);

}  // namespace synthetic_dataset::programs
