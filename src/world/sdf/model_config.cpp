#include "world/sdf/model_config.h"

#include <string>
#include <system_error>
#include <vector>

#include <tinyxml2.h>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "synthetic_dataset/errors.h"
#include "world/files/resource_finder.h"
#include "world/sdf/sdf_file.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// A file of a model, for a version of SDF.
struct Listed {
  SdfVersion version;
  fs::path file;
};

fs::path configOf(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : {"model.config", "manifest.xml"}) {
    if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  }
  throw Error("'" + folder.string() + "' is a folder without a model.config");
}

std::vector<Listed> listedIn(const fs::path& config) {
  tinyxml2::XMLDocument document;
  if (const auto fault = base::parseXml(document, base::readInput(config))) {
    throw Error("'" + config.string() + "': " + fault->text());
  }
  const tinyxml2::XMLElement* model = document.FirstChildElement("model");
  std::vector<Listed> files;
  const tinyxml2::XMLElement* sdf = model != nullptr ? model->FirstChildElement("sdf") : nullptr;
  for (; sdf != nullptr; sdf = sdf->NextSiblingElement("sdf")) {
    const char* name = sdf->GetText();
    if (name == nullptr) continue;
    files.push_back({parseSdfVersion(sdf->Attribute("version")), config.parent_path() / name});
  }
  return files;
}

/// Whether `a` is to be preferred to `b`.
bool isBetter(const Listed& a, const Listed& b) {
  const bool a_known = a.version <= kNewestSdfVersion;
  const bool b_known = b.version <= kNewestSdfVersion;
  if (a_known != b_known) return a_known;
  return a_known ? a.version > b.version : a.version < b.version;
}

}  // namespace

fs::path modelFileOf(const fs::path& folder) {
  const fs::path config = configOf(folder);
  const std::vector<Listed> files = listedIn(config);
  if (files.empty()) throw Error("'" + config.string() + "' lists no <sdf> file");
  const Listed* best = nullptr;
  for (const Listed& each : files) {
    std::error_code ignored;
    if (!isWithin(each.file, folder)) {
      throw Error("'" + config.string() + "' lists '" + each.file.string() +
                  "', which is not in the model's folder, and is not read");
    }
    const bool there = fs::is_regular_file(each.file, ignored);
    if (there && (best == nullptr || isBetter(each, *best))) best = &each;
  }
  if (best == nullptr) {
    throw Error("'" + config.string() + "' lists '" + files.front().file.string() +
                "', which is not there");
  }
  return best->file;
}

}  // namespace synthetic_dataset::world
