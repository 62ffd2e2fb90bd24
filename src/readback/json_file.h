#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "readback/files.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::readback {

/// Does what reads JSON of a file: what it finds missing or of another kind than it should be
/// becomes an Error that names the file.
template <class Read>
auto readingJson(const std::filesystem::path& file, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw Error("'" + file.string() + "': " + error.what());
  }
}

/// What `read` makes of a file's JSON.
/// @throws Error naming the file where it is no JSON, or not what `read` looks for
template <class Read>
auto readJson(const std::filesystem::path& file, const Read& read) {
  return readingJson(file, [&] { return read(nlohmann::json::parse(readText(file))); });
}

}  // namespace synthetic_dataset::readback
