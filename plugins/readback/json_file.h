#pragma once

#include <filesystem>
#include <limits>
#include <string>

#include <nlohmann/json.hpp>

#include "plugins/readback/files.h"
#include "plugins/shared/json.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

/// Returns an integer after checking its range. (nlohmann's conversion accepts any number, even
/// 1e99, with an arbitrary result.)
/// @throws UnfitJson, or nlohmann's exception if it is not a number
template <class Integer = int>
[[nodiscard]] Integer integerOf(const nlohmann::json& value) {
  using Limits = std::numeric_limits<Integer>;
  const auto number = value.get<double>();
  const bool fits = value.is_number_integer() && number >= static_cast<double>(Limits::min()) &&
                    number <= static_cast<double>(Limits::max());
  if (!fits) throw UnfitJson("found the number " + value.dump() + " where no such number can be");
  return value.get<Integer>();
}

/// Calls a function that reads a file's JSON: members that are missing or of the wrong type become
/// an Error that names the file.
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

/// Returns what `read` makes of a file's JSON.
/// @throws Error naming the file if it is not JSON, or not what `read` expects
template <class Read>
auto readJson(const std::filesystem::path& file, const Read& read) {
  return readingJson(file, [&] { return read(parsedJson<nlohmann::json>(readText(file))); });
}

}  // namespace synthetic_dataset::formats
