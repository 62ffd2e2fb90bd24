#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "plugins/readback/json_file.h"

namespace synthetic_dataset::formats {

/// A JSON file's content, to be kept from scene to scene.
struct JsonDocument {
  explicit JsonDocument(const std::filesystem::path& file)
      : content(readJson(file, [](const nlohmann::json& json) { return json; })) {}

  nlohmann::json content;
};

}  // namespace synthetic_dataset::formats
