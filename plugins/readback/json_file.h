#pragma once

#include <filesystem>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "plugins/readback/files.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

/// A whole number that fits. (nlohmann's conversion takes any number: of 1e99, whatever comes.)
/// @throws UnfitJson, or nlohmann's exception where it is no number
template <class Integer = int>
[[nodiscard]] Integer integerOf(const nlohmann::json& value) {
  using Limits = std::numeric_limits<Integer>;
  const auto number = value.get<double>();
  const bool fits = value.is_number_integer() && number >= static_cast<double>(Limits::min()) &&
                    number <= static_cast<double>(Limits::max());
  if (!fits) throw UnfitJson("found the number " + value.dump() + " where none such can be");
  return value.get<Integer>();
}

/// Does what reads JSON of a file: what it finds missing or of another kind than it should be
/// becomes an Error that names the file.
template <class Read>
auto readingJson(const std::filesystem::path& file, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception& error) {
    throw Error("'" + file.string() + "': " + error.what());
  } catch (const UnfitJson& error) {
    throw Error("'" + file.string() + "': " + error.what());
  }
}

/// What `read` makes of a file's JSON.
/// @throws Error naming the file where it is no JSON, or not what `read` looks for
template <class Read>
auto readJson(const std::filesystem::path& file, const Read& read) {
  return readingJson(file, [&] { return read(parsedJson<nlohmann::json>(readText(file))); });
}

}  // namespace synthetic_dataset::formats
