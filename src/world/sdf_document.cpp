#include "world/sdf_document.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <sdf/Light.hh>
#include <sdf/Model.hh>
#if SDF_MAJOR_VERSION >= 11
#include <sdf/ParserConfig.hh>
#else
#include <sdf/SDFImpl.hh>
#endif
#include <sdf/World.hh>

#include "world/sdf_console.h"

namespace synthetic_dataset::world {
namespace {

namespace fs = std::filesystem;

/// Answers libsdformat's questions for files: the same URI may mean different files in different
/// places, and the order of asking tells which.
class Answers {
 public:
  explicit Answers(IncludeGraph::Targets targets) : targets_(std::move(targets)) {}

  std::string operator()(const std::string& uri) {
    const auto found = targets_.find(uri);
    if (found == targets_.end()) return "";
    const std::vector<fs::path>& paths = found->second;
    std::size_t& next = asked_[uri];
    const fs::path& path = paths[std::min(next, paths.size() - 1)];
    ++next;
    return path.string();
  }

 private:
  IncludeGraph::Targets targets_;
  std::map<std::string, std::size_t> asked_;
};

bool isUnambiguous(const std::vector<fs::path>& paths) {
  for (const fs::path& path : paths) {
    if (path != paths.front()) return false;
  }
  return !paths.front().empty();
}

/// libsdformat looks into the working folder, its own and SDF_PATH's before it asks; only prefixes
/// that are mapped to folders go before those.
template <class AddUriPath>
void mapPrefixes(const IncludeGraph::Targets& targets, const AddUriPath& add) {
  for (const auto& [uri, paths] : targets) {
    if (!isUnambiguous(paths)) continue;
    const fs::path& path = paths.front();
    const std::size_t slash = uri.rfind('/');
    if (fs::is_directory(path)) {
      add(uri, path.string());
    } else if (slash != std::string::npos && uri.substr(slash + 1) == path.filename()) {
      add(uri.substr(0, slash + 1), path.parent_path().string());
    }
  }
}

#if SDF_MAJOR_VERSION >= 11
/// libsdformat's settings for as long as it lives: it reads the includes of included files with
/// the global ones, whatever it is given.
class GlobalSettings {
 public:
  explicit GlobalSettings(const sdf::ParserConfig& config)
      : before_(sdf::ParserConfig::GlobalConfig()) {
    sdf::ParserConfig::GlobalConfig() = config;
  }
  ~GlobalSettings() { sdf::ParserConfig::GlobalConfig() = before_; }
  GlobalSettings(const GlobalSettings&) = delete;
  GlobalSettings& operator=(const GlobalSettings&) = delete;

 private:
  sdf::ParserConfig before_;
};

sdf::Errors load(sdf::Root& root, const fs::path& file, const IncludeGraph& includes) {
  sdf::ParserConfig config;
  mapPrefixes(includes.targets(), [&](const std::string& uri, const std::string& folder) {
    config.AddURIPath(uri, folder);
  });
  // Copies of the settings have to count the questions together.
  const auto answers = std::make_shared<Answers>(includes.targets());
  config.SetFindCallback([answers](const std::string& uri) { return (*answers)(uri); });
  const GlobalSettings settings(config);
  return root.Load(file.string(), config);
}
#else
sdf::Errors load(sdf::Root& root, const fs::path& file, const IncludeGraph& includes) {
  mapPrefixes(includes.targets(), [](const std::string& uri, const std::string& folder) {
    sdf::addURIPath(uri, folder);
  });
  sdf::setFindCallback(Answers(includes.targets()));
  return root.Load(file.string());
}
#endif

bool startsWith(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

/// What the graph of includes has told, or what does not touch the picture: Gazebo shows models
/// with impossible inertias, and scripts without <uri> are its own.
bool isTolerable(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::URI_LOOKUP ||
         error.Code() == sdf::ErrorCode::LINK_INERTIA_INVALID ||
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
  for (const std::string& text : texts) result += ": " + text;
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
  for (const std::string& text : console.unreported()) {
    const bool told = text.find("Unable to find uri") != std::string::npos;
    if (!told) result.push_back(file + ": " + text);
  }
  const auto tolerable = std::count_if(errors.begin(), errors.end(), isTolerable);
  if (result.empty() && !errors.empty() && tolerable == 0) {
    result.push_back(describe(errors.front(), file) + joined(console.reasons()));
  }
  return result;
}

bool leavesPosesUnknown(const sdf::Error& error) {
  return error.Code() == sdf::ErrorCode::URI_LOOKUP;
}

}  // namespace

SdfDocument::SdfDocument(const fs::path& file, const IncludeGraph& includes, Findings& findings) {
  const SdfConsole console;
  std::vector<std::string> faults;
  try {
    const sdf::Errors errors = load(root_, file, includes);
    faults = causes(errors, console, file.string());
    sound_ = faults.empty() && std::none_of(errors.begin(), errors.end(), leavesPosesUnknown);
  } catch (const std::exception& error) {
    faults.push_back(file.string() + ": " + error.what());
    sound_ = false;
  }
  for (const std::string& fault : faults) findings.addError(fault);
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
  // Every file is read by its absolute path; what libsdformat makes up, as from URDF, has a name
  // that is no path.
  return file.empty() || file.front() != '/' ? "" : file;
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
  const std::string where = error.FilePath().value_or(file);
  const auto line = error.LineNumber();
  return where + (line ? ": line " + std::to_string(*line) : "") + ": " + error.Message();
#else
  return file + ": " + error.Message();
#endif
}

}  // namespace synthetic_dataset::world
