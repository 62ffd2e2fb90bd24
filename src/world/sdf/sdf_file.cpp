#include "world/sdf/sdf_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "synthetic_dataset/errors.h"
#include "world/files/template_file.h"
#include "world/files/text.h"
#include "world/sdf/gz_plugins.h"
#include "world/sdf/xml_repair.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// SDF's oldest versions call their root <gazebo>.
void readRoot(SdfFile& file) {
  const tinyxml2::XMLElement* root = file.document.RootElement();
  const std::string name = root != nullptr ? root->Name() : "";
  file.is_urdf = name == "robot";
  if (file.is_urdf) return;
  if (name != "sdf" && name != "gazebo") {
    throw Error(file.path.string() + ": its root element is <" + name +
                ">; <sdf> is needed, or <robot> of a URDF file");
  }
  const char* version = root->Attribute("version");
  if (version != nullptr && isSdfVersion(version)) {
    file.version = parseSdfVersion(version);
    return;
  }
  file.odd = "line " + std::to_string(root->GetLineNum()) + ": <" + name + "> has " +
             (version == nullptr ? "no version"
                                 : "the version '" + std::string(version) + "', which is invalid") +
             "; it is read as version 1.6";
}

/// Looks for plugins of gz-sim.
class GzPluginSearch : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute*) override {
    if (std::string(element.Name()) != "plugin") return !found;
    const auto attribute = [&](const char* name) {
      const char* text = element.Attribute(name);
      return std::string(text != nullptr ? text : "");
    };
    found = found || isPluginOfGz(attribute("filename"), attribute("name"));
    return false;
  }

  bool found = false;
};

bool hasPluginOfGz(const tinyxml2::XMLDocument& document) {
  GzPluginSearch search;
  document.Accept(&search);
  return search.found;
}

/// Whose template a file is, if a program has to expand it first: "xacro's"; null if it is not a
/// template.
/// @param text  of one of the file's elements or attributes
const char* templateOf(const std::string& text) {
  if (text.find("${") != std::string::npos) return "xacro's";
  const bool is_jinjas =
      text.find("{{") != std::string::npos || text.find("{%") != std::string::npos;
  return is_jinjas ? "Jinja's" : nullptr;
}

/// Looks for unexpanded parts of a template outside of plugins, whose settings may contain
/// anything.
class TemplateSearch : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const tinyxml2::XMLElement& element,
                  const tinyxml2::XMLAttribute* attribute) override {
    const std::string name = element.Name();
    // Definitions that nothing uses may stay in a world, as Gazebo ignores them.
    const bool defines = name == "xacro:arg" || name == "xacro:property";
    if (!defines && name.rfind("xacro:", 0) == 0) take("xacro's", name, element.GetLineNum());
    if (defines) return false;
    for (; attribute != nullptr; attribute = attribute->Next()) {
      take(templateOf(attribute->Value()), attribute->Value(), attribute->GetLineNum());
    }
    return found.empty() && name != "plugin";
  }

  bool Visit(const tinyxml2::XMLText& text) override {
    take(templateOf(text.Value()), text.Value(), text.GetLineNum());
    return found.empty();
  }

  std::string found;

 private:
  void take(const char* whose, const std::string& what, int line) {
    if (whose == nullptr || !found.empty()) return;
    const bool is_xacros = std::string(whose) == "xacro's";
    found = "line " + std::to_string(line) + ": '" + trimmed(what) + "' is " + whose +
            ", which expands it if the file's name ends in " + (is_xacros ? ".xacro" : ".jinja");
  }
};

/// The error for an ERB template (`<% %>`), which is not XML; empty for other texts.
std::string erbFault(const std::string& text) {
  const std::size_t at = text.find("<%");
  if (at == std::string::npos) return "";
  const auto line =
      1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return "line " + std::to_string(line) +
         ": '<%' is ERB's: the file is a template; `erb FILE > world.sdf` expands it";
}

std::unique_ptr<SdfFile> parsed(const fs::path& name, std::string text) {
  auto file = std::make_unique<SdfFile>();
  file->path = name;
  try {
    readXml(text, *file);
  } catch (const Error&) {
    const std::string fault = erbFault(text);
    if (fault.empty()) throw;
    throw Error(name.string() + ": " + fault);
  }
  readRoot(*file);
  if (!file->is_urdf) {
    TemplateSearch search;
    file->document.Accept(&search);
    if (!search.found.empty()) throw Error(name.string() + ": " + search.found);
  }
  file->is_of_gz = !file->is_urdf && hasPluginOfGz(file->document);
  if (file->is_urdf) file->text = std::move(text);
  return file;
}

}  // namespace

void readXml(const std::string& text, SdfFile& file) {
  const auto fault = base::parseXml(file.document, text);
  if (!fault || !base::parseXml(file.document, repairedXml(text))) return;
  const std::string of_text = base::textFault(text);
  throw Error(file.path.string() + ": " + (of_text.empty() ? fault->text() : of_text));
}

bool isSdfVersion(const std::string& text) {
  const std::size_t point = text.find('.');
  const auto isNumber = [](const std::string& digits) {
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string::npos;
  };
  return isNumber(text.substr(0, point)) &&
         (point == std::string::npos || isNumber(text.substr(point + 1)));
}

SdfVersion parseSdfVersion(const char* text) {
  if (text == nullptr) return {0, 0};
  char* end = nullptr;
  const long major = std::strtol(text, &end, 10);
  return {major, *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0};
}

const SdfFile& SdfFiles::read(const fs::path& file) {
  return keep(file.string(), file,
              [&] { return isTemplate(file) ? expandTemplate(file, {}) : base::readInput(file); });
}

const SdfFile& SdfFiles::readText(const fs::path& name, const std::string& text) {
  return keep(name.string() + "\n" + text, name, [&] { return text; });
}

const SdfFile& SdfFiles::keep(const std::string& key, const fs::path& name,
                              const std::function<std::string()>& text) {
  auto known = files_.find(key);
  if (known == files_.end()) {
    std::variant<std::unique_ptr<SdfFile>, std::string> result;
    try {
      result = parsed(name, text());
    } catch (const Error& error) {
      result = std::string(error.what());
    }
    known = files_.emplace(key, std::move(result)).first;
  }
  if (const auto* fault = std::get_if<std::string>(&known->second)) throw Error(*fault);
  return *std::get<std::unique_ptr<SdfFile>>(known->second);
}

}  // namespace synthetic_dataset::world
