#include "programs/setup_assistant/service/document_service.h"

#include <utility>
#include <vector>

#include "config/settings_file.h"
#include "config/twin_runs.h"
#include "programs/setup_assistant/document/settings_names.h"
#include "programs/setup_assistant/service/request_body.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

base::YamlChange changeOf(const Value& value) {
  base::YamlChange change;
  change.path = pathOf(requiredOf(value, "path"));
  const Value& wanted = requiredOf(value, "value");
  if (!wanted.isNull()) change.value = wanted;
  return change;
}

Value outsideValue(const SettingsDocument& document) {
  if (!document.outside()) return false;
  return Value::Map{{"text", Value(*document.outside())}};
}

Value faultValue(const SettingsDocument& document) {
  if (!document.fault()) return {};
  return Value::Map{{"message", Value(document.fault()->message)},
                    {"line", Value(document.fault()->line)}};
}

}  // namespace

DocumentService::DocumentService(std::string file, const AllowedFolders& allowed,
                                 OnChange on_change)
    : document_(std::move(file)), allowed_(allowed), on_change_(std::move(on_change)) {
  rememberVariables();
}

template <class Work>
Value DocumentService::changing(const Work& work) {
  Value state;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    work();
    state = stateLocked();
  }
  on_change_();
  return state;
}

Value DocumentService::state() {
  const std::lock_guard<std::mutex> lock(mutex_);
  document_.look();
  return stateLocked();
}

Value DocumentService::set(const Value& body) {
  const std::int64_t revision = wholeNumberOf(body, "revision");
  const auto* list = requiredOf(body, "changes").as<Value::List>();
  if (list == nullptr) throw Error("changes: it should be a list");
  std::vector<base::YamlChange> changes;
  for (const Value& each : *list) changes.push_back(changeOf(each));
  return changing([&] { document_.change(revision, changes, textOf(body, "step")); });
}

Value DocumentService::type(const Value& body) {
  const std::int64_t revision = wholeNumberOf(body, "revision");
  const auto* text = requiredOf(body, "text").as<std::string>();
  if (text == nullptr) throw Error("text: it should be a text");
  return changing([&] { document_.type(revision, *text, textOf(body, "step")); });
}

Value DocumentService::undo() {
  return changing([&] { document_.undo(); });
}

Value DocumentService::redo() {
  return changing([&] { document_.redo(); });
}

Value DocumentService::decideOutside(const Value& body) {
  const auto* take = requiredOf(body, "take").as<bool>();
  if (take == nullptr) throw Error("take: it should be true or false");
  return changing([&] { *take ? document_.acceptExternal() : document_.overwriteExternal(); });
}

void DocumentService::look() {
  bool is_new = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_new = document_.look();
  }
  if (is_new) on_change_();
}

void DocumentService::requireOnDisk() {
  const std::lock_guard<std::mutex> lock(mutex_);
  document_.look();
  if (document_.outside()) throw HttpError(409, "somebody else has changed the settings file");
  if (document_.fault()) throw HttpError(409, document_.fault()->message);
}

std::int64_t DocumentService::revision() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return document_.revision();
}

EffectiveSettings DocumentService::effective() {
  const std::lock_guard<std::mutex> lock(mutex_);
  readEffective();
  return effective_;
}

Value DocumentService::stateLocked() {
  readEffective();
  return Value::Map{{"file", Value(document_.file())},
                    {"text", Value(document_.text())},
                    {"revision", Value(document_.revision())},
                    {"settings", document_.settings()},
                    {"effective", effective_.settings.value_or(Value())},
                    {"can_undo", Value(document_.canUndo())},
                    {"can_redo", Value(document_.canRedo())},
                    {"outside", outsideValue(document_)},
                    {"error", faultValue(document_)}};
}

/// Restricts files and variables: the page could otherwise show the contents of files that it may
/// not look into, and of variables that the user has not named.
Value DocumentService::load(const config::TextFinder& environment) const {
  config::SettingsSources sources;
  sources.package_folder = packages_.finder();
  sources.environment = environment;
  sources.admit = [this](const std::string& file) { (void)allowed_.resolve(file); };
  return config::loadSettings(document_.file(), sources);
}

void DocumentService::rememberVariables() {
  try {
    (void)load([this](const std::string& name) {
      variables_.insert(name);
      return config::environmentVariable(name);
    });
  } catch (const Error&) {  // reported when the page asks
  }
}

std::optional<std::string> DocumentService::variable(const std::string& name) const {
  if (variables_.count(name) != 0) return config::environmentVariable(name);
  throw Error("found the environment variable " + name +
              ", which the settings did not name when the page was started; restart "
              "setup_assistant to allow it");
}

/// If the text that is shown is not on the disk, the settings that were read last stay.
void DocumentService::readEffective() {
  if (effective_.revision == document_.revision()) return;
  effective_.revision = document_.revision();
  if (document_.fault() || document_.outside()) return;
  effective_.errors.clear();
  effective_.settings.reset();
  try {
    const Value all = load([this](const std::string& name) { return variable(name); });
    effective_.settings = config::twinRuns(all).front();
  } catch (const ErrorList& errors) {
    effective_.errors = errors.messages();
  } catch (const Error& error) {
    effective_.errors = {error.what()};
  }
}

}  // namespace synthetic_dataset::programs
