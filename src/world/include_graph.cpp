#include "world/include_graph.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <system_error>

#include <tinyxml2.h>

#include "synthetic_dataset/errors.h"
#include "world/model_config.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// More is taken for files that multiply one another.
constexpr int kMostIncludes = 20000;

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

void forEachInclude(const tinyxml2::XMLElement& parent,
                    const std::function<void(const tinyxml2::XMLElement&)>& visit) {
  for (const auto* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (std::string(child->Name()) == "include") {
      visit(*child);
    } else {
      forEachInclude(*child, visit);
    }
  }
}

/// The one path of a file that may have several.
fs::path identity(const fs::path& file) {
  std::error_code error;
  const fs::path result = fs::canonical(file, error);
  return error ? file : result;
}

/// Why a file is no world or model, or nothing.
std::optional<std::string> fault(const tinyxml2::XMLDocument& document, const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) return "is a folder; a file is needed";
  if (document.Error()) {
    return "line " + std::to_string(document.ErrorLineNum()) + ": cannot be read as XML (" +
           document.ErrorName() + ")";
  }
  const tinyxml2::XMLElement* root = document.RootElement();
  const std::string name = root != nullptr ? root->Name() : "";
  if (name == "sdf" || name == "gazebo" || name == "robot") return std::nullopt;
  return "its root element is <" + name + ">; <sdf> is needed, or <robot> of a URDF file";
}

}  // namespace

IncludeGraph::IncludeGraph(const fs::path& file, const ResourceFinder& finder, Findings& findings)
    : finder_(finder), findings_(findings) {
  follow(file);
}

const std::vector<IncludeGraph::Include>* IncludeGraph::includesOf(const fs::path& file) {
  const auto known = files_.find(file.string());
  if (known != files_.end()) return &known->second;
  tinyxml2::XMLDocument document;
  document.LoadFile(file.c_str());
  if (const auto reason = fault(document, file)) {
    findings_.addError(file.string() + ": " + *reason);
    return nullptr;
  }
  std::vector<Include> includes;
  forEachInclude(*document.RootElement(), [&](const tinyxml2::XMLElement& element) {
    const tinyxml2::XMLElement* uri = element.FirstChildElement("uri");
    const char* text = uri != nullptr ? uri->GetText() : nullptr;
    if (text == nullptr) {
      findings_.addError(file.string() + ": line " + std::to_string(element.GetLineNum()) +
                         ": <include> has no <uri>");
      readable_ = false;
      return;
    }
    includes.push_back({text, uri->GetLineNum()});
  });
  return &files_.emplace(file.string(), std::move(includes)).first->second;
}

void IncludeGraph::follow(const fs::path& file) {
  const std::vector<Include>* includes = includesOf(file);
  if (includes == nullptr) {
    readable_ = false;
    return;
  }
  chain_.push_back(identity(file));
  for (const Include& include : *includes) {
    if (++count_ > kMostIncludes) {
      if (count_ == kMostIncludes + 1) {
        findings_.addError(chain_.front().string() + ": includes more than " +
                           std::to_string(kMostIncludes) + " files");
      }
      readable_ = false;
      break;
    }
    followInclude(file, include);
  }
  chain_.pop_back();
}

void IncludeGraph::followInclude(const fs::path& file, const Include& include) {
  const std::string place = file.string() + ": line " + std::to_string(include.line) +
                            ": include '" + trimmed(include.uri) + "': ";
  const fs::path folder = file.parent_path();
  const std::optional<fs::path> found = finder_.find(trimmed(include.uri), folder);
  targets_[include.uri].push_back(found.value_or(fs::path()));
  if (!found) {
    if (!reported_.emplace(file.string(), include.uri).second) return;
    findings_.addError(place + "no such file; " +
                       finder_.searchedPlaces(trimmed(include.uri), folder));
    return;
  }
  fs::path model = *found;
  try {
    if (fs::is_directory(model)) model = modelFileOf(model);
  } catch (const std::exception& error) {
    findings_.addError(place + error.what());
    targets_[include.uri].back().clear();
    return;
  }
  if (std::find(chain_.begin(), chain_.end(), identity(model)) != chain_.end()) {
    findings_.addError(place + "includes itself, by way of " + std::to_string(chain_.size()) +
                       " file(s)");
    readable_ = false;
    return;
  }
  follow(model);
}

}  // namespace synthetic_dataset::world
