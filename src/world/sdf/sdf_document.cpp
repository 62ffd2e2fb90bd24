#include "world/sdf/sdf_document.h"

#include <algorithm>
#include <exception>
#include <string>
#include <vector>

#include <sdf/Light.hh>
#include <sdf/Model.hh>
#include <sdf/World.hh>

#include "world/files/text.h"
#include "world/sdf/joined_models.h"
#include "world/sdf/sdf_console.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// What does not touch the picture: Gazebo shows models with impossible inertias, and scripts
/// without <uri> are its own.
bool isTolerable(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::LINK_INERTIA_INVALID ||
         startsWith(error.Message(), "A <script> element is missing a child <uri>");
}

/// What follows from another error: each element above the bad one, then the file as a whole.
bool isEcho(const sdf::Error& error) {
  return startsWith(error.Message(), "Failed to load a world") ||
         startsWith(error.Message(), "Unable to read file") ||
         startsWith(error.Message(), "Could not find the 'robot' element");
}

std::string joined(const std::vector<std::string>& texts) {
  std::string result;
  for (const std::string& text : texts) {
    // What is said of each file that is no SDF, when it is tried as URDF.
    if (!startsWith(text, "Could not find the 'robot' element")) result += ": " + text;
  }
  return result;
}

/// The errors that are causes, the innermost element's with the reason that the console was told.
std::vector<std::string> causes(const sdf::Errors& errors, const SdfConsole& console,
                                const std::string& file) {
  std::vector<std::string> result;
  bool in_chain = false;
  for (const sdf::Error& error : errors) {
    const bool link = startsWith(error.Message(), "Error reading element");
    if (!isTolerable(error) && !isEcho(error) && !(link && in_chain)) {
      result.push_back(describe(error, file) + (link ? joined(console.reasons()) : ""));
    }
    in_chain = link;
  }
  for (const std::string& text : console.unreported()) result.push_back(file + ": " + text);
  const auto tolerable = std::count_if(errors.begin(), errors.end(), isTolerable);
  if (result.empty() && !errors.empty() && tolerable == 0) {
    result.push_back(describe(errors.front(), file) + joined(console.reasons()));
  }
  return result;
}

}  // namespace

SdfDocument::SdfDocument(const fs::path& file, const fs::path& prepared_file,
                         const SdfCopies& copies, Findings& findings) {
  const SdfConsole console;
  std::vector<std::string> faults;
  try {
    faults = causes(root_.Load(prepared_file.string()), console, file.string());
  } catch (const std::exception& error) {
    faults.push_back(file.string() + ": " + error.what());
  }
  sound_ = faults.empty();
  for (const std::string& fault : faults) findings.addError(copies.withOriginalPaths(fault));
}

sdf::ElementPtr SdfDocument::element() const {
  if (world() != nullptr) return world()->Element();
  return model() != nullptr ? model()->Element() : nullptr;
}

const sdf::World* SdfDocument::world() const {
  return root_.WorldCount() > 0 ? root_.WorldByIndex(0) : nullptr;
}

const sdf::Model* SdfDocument::model() const {
#if SDF_MAJOR_VERSION >= 11
  return root_.Model();
#else
  return root_.ModelCount() > 0 ? root_.ModelByIndex(0) : nullptr;
#endif
}

const sdf::Light* SdfDocument::light() const {
#if SDF_MAJOR_VERSION >= 11
  return root_.Light();
#else
  return root_.LightCount() > 0 ? root_.LightByIndex(0) : nullptr;
#endif
}

std::string fileOf(const sdf::ElementPtr& element) {
  if (!element) return "";
  const std::string& file = element->FilePath();
  for (auto each = element; each && each->FilePath() == file; each = each->GetParent()) {
    if (each->HasAttribute(kJoinedFrom)) return each->Get<std::string>(kJoinedFrom);
  }
  // Every file is read by its absolute path; what libsdformat makes up, as from URDF, has a name
  // that is no path.
  return file.empty() || file.front() != '/' ? "" : originalOf(file);
}

bool isInFile(const sdf::ElementPtr& element) {
#if SDF_MAJOR_VERSION >= 11
  return element->GetExplicitlySetInFile();
#else
  return element != nullptr;
#endif
}

std::string describe(const sdf::Error& error, const std::string& file) {
#if SDF_MAJOR_VERSION >= 11
  // What is read from no file has a name that is no path ("<data-string>").
  const std::string path = error.FilePath().value_or(file);
  const std::string& where = path.empty() || path.front() != '/' ? file : path;
  const auto line = error.LineNumber();
  return where + (line ? ": line " + std::to_string(*line) : "") + ": " + error.Message();
#else
  return file + ": " + error.Message();
#endif
}

}  // namespace synthetic_dataset::world
