#include "world/model_config.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include <sdf/sdf_config.h>
#include <tinyxml2.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// A version of SDF, "1.10" after "1.9".
using Version = std::pair<long, long>;

Version parseVersion(const char* text) {
  if (text == nullptr) return {0, 0};
  char* end = nullptr;
  const long major = std::strtol(text, &end, 10);
  return {major, *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0};
}

}  // namespace

fs::path modelFileOf(const fs::path& folder) {
  const fs::path config = folder / "model.config";
  std::error_code ignored;
  if (!fs::exists(config, ignored)) {
    throw Error("'" + folder.string() + "' is a folder without a model.config");
  }
  tinyxml2::XMLDocument document;
  if (document.LoadFile(config.c_str()) != tinyxml2::XML_SUCCESS) {
    throw Error("'" + config.string() + "' is not XML: " + document.ErrorStr());
  }
  const tinyxml2::XMLElement* model = document.FirstChildElement("model");
  Version best{-1, 0};
  fs::path file;
  const tinyxml2::XMLElement* sdf = model != nullptr ? model->FirstChildElement("sdf") : nullptr;
  for (; sdf != nullptr; sdf = sdf->NextSiblingElement("sdf")) {
    const Version version = parseVersion(sdf->Attribute("version"));
    if (sdf->GetText() == nullptr || version <= best || version > parseVersion(SDF_VERSION)) {
      continue;
    }
    best = version;
    file = folder / sdf->GetText();
  }
  if (file.empty()) {
    throw Error("'" + config.string() + "' lists no <sdf> file of a version up to " SDF_VERSION);
  }
  if (!fs::exists(file, ignored)) {
    throw Error("'" + config.string() + "' lists '" + file.string() + "', which is not there");
  }
  return file;
}

}  // namespace synthetic_dataset::world
