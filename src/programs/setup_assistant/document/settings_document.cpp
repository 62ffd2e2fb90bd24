#include "programs/setup_assistant/document/settings_document.h"

#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>
#include <utility>

#include "base/input_file.h"
#include "base/yaml_value.h"
#include "output/files/pending_file.h"
#include "programs/setup_assistant/document/filled_gaps.h"
#include "programs/setup_assistant/document/settings_names.h"
#include "programs/setup_assistant/web/http_message.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::size_t kMostSteps = 1000;

/// From a message such as "settings.yaml: line 3: ..."
TextFault faultOf(const std::string& message) {
  static const std::regex kLine("line ([0-9]{1,9})");
  std::smatch match;
  TextFault fault{message, 0};
  if (std::regex_search(message, match, kLine)) fault.line = std::stoll(match[1]);
  return fault;
}

std::string fileNameOf(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

}  // namespace

void writeWhole(const std::string& file, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code none;
  const fs::path target = fs::exists(file, none) ? fs::canonical(file) : fs::absolute(file);
  const auto write = [&](const std::string& pending_name) {
    std::ofstream stream(pending_name, std::ios::binary);
    if (fs::exists(target)) {
      fs::permissions(pending_name, fs::status(target).permissions(), none);
    }
    if (!(stream << content << std::flush)) throw Error("'" + file + "' cannot be written");
  };
  auto pending = output::PendingFile::writtenBy(target.string(), write);
  pending.publish();
  pending.keep();
}

SettingsDocument::SettingsDocument(std::string file)
    : file_(std::move(file)), written_(base::readInput(file_)) {
  show(*written_);
}

void SettingsDocument::change(std::int64_t revision, const std::vector<base::YamlChange>& changes,
                              const std::string& step) {
  requireCurrent(revision);
  if (fault_)
    throw HttpError(409, "the text is not valid YAML: " + fault_->message + "; correct it first");
  std::string text = text_;
  for (base::YamlChange each : changes) {
    each.path = pathAsWritten(each.path, base::readYamlText(text, fileNameOf(file_)));
    text = base::editYaml(text, fileNameOf(file_), {each}, documentedOrder);
    if (each.value) text = withoutGap(text, fileNameOf(file_), each.path);
  }
  if (text == text_) return;
  record(step);
  show(text);
  write();
}

void SettingsDocument::type(std::int64_t revision, const std::string& text,
                            const std::string& step) {
  requireCurrent(revision);
  if (text == text_) return;
  const std::string fault = base::textFault(text);
  if (!fault.empty()) throw Error("the text " + fault);
  record(step);
  show(text);
  write();
}

void SettingsDocument::undo() {
  requireNobodyElse();
  moveTo(past_, future_);
}

void SettingsDocument::redo() {
  requireNobodyElse();
  moveTo(future_, past_);
}

bool SettingsDocument::look() {
  const auto found = onDisk();
  const auto before = outside_;
  if (found == written_) {
    outside_.reset();
  } else if (found == text_) {  // somebody else has written the same text
    written_ = found;
    outside_.reset();
  } else {
    outside_ = found.value_or("");
  }
  return before != outside_;
}

void SettingsDocument::acceptExternal() {
  look();
  if (!outside_) return;
  const std::string theirs = *outside_;
  written_ = onDisk();
  outside_.reset();
  record("");
  show(theirs);
  write();  // if the file is gone, makes it again
}

void SettingsDocument::overwriteExternal() {
  look();
  written_ = onDisk();
  outside_.reset();
  ++revision_;
  write();
}

void SettingsDocument::requireCurrent(std::int64_t revision) {
  requireNobodyElse();
  if (revision == revision_) return;
  throw HttpError(409, "found revision " + std::to_string(revision) + "; it should be " +
                           std::to_string(revision_) + ", since another page changed the file");
}

void SettingsDocument::requireNobodyElse() {
  look();
  if (!outside_) return;
  throw HttpError(
      409,
      fileNameOf(file_) + ": somebody else has changed the file; take their text or keep your own");
}

void SettingsDocument::show(const std::string& text) {
  text_ = text;
  ++revision_;
  try {
    const std::string origin = fileNameOf(file_);
    const Value tree =
        withAnglesAsWritten(base::readYamlText(text, origin), base::parseYaml(text, origin));
    settings_ = asGroups(tree, origin);
    fault_.reset();
  } catch (const Error& error) {
    fault_ = faultOf(error.what());
  }
}

void SettingsDocument::record(const std::string& step) {
  future_.clear();
  if (!step.empty() && !past_.empty() && past_.back().step == step) return;
  past_.push_back({text_, step});
  if (past_.size() > kMostSteps) past_.erase(past_.begin());
}

void SettingsDocument::moveTo(std::vector<Earlier>& from, std::vector<Earlier>& to) {
  if (from.empty()) return;
  const Earlier wanted = from.back();
  from.pop_back();
  to.push_back({text_, wanted.step});
  show(wanted.text);
  write();
}

void SettingsDocument::write() {
  if (fault_ || written_ == text_) return;
  writeWhole(file_, text_);
  written_ = text_;
}

std::optional<std::string> SettingsDocument::onDisk() const {
  try {
    return base::readInput(file_);
  } catch (const Error&) {  // it is gone, or cannot be read for now
    return std::nullopt;
  }
}

}  // namespace synthetic_dataset::programs
