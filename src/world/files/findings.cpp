#include "world/files/findings.h"

#include <algorithm>

#include "base/input_file.h"

namespace synthetic_dataset::world {
namespace {

constexpr const char* kSearch = "looked in ";

/// The number of further models that one message names at most.
constexpr std::size_t kMostModels = 5;

bool isListed(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

void addOnce(std::vector<std::string>& list, const std::string& message) {
  if (!isListed(list, message)) list.push_back(message);
}

/// The "model 'shelf'" part of a message about something in a model; empty for other messages.
std::string modelOf(const std::string& message) {
  const std::string kind = "model '";
  const std::size_t begin = message.find(": " + kind);
  if (begin == std::string::npos) return "";
  const std::size_t end = message.find("': ", begin + 2 + kind.size());
  return end == std::string::npos ? "" : message.substr(begin + 2, end + 1 - (begin + 2));
}

}  // namespace

void Findings::addError(const std::string& message) { addOnce(errors, message); }

void Findings::addNote(const std::string& message) { addOnce(notes, message); }

void Findings::addNote(const SourceLocation& location, const std::string& remark) {
  add(location.prefix(), remark, "", "", noted_, notes);
}

void Findings::addMissing(const SourceLocation& location, const std::string& thing) {
  if (base::isAboutPipe(thing))
    return addError(location.prefix() + thing);  // the file exists, but is of the wrong kind
  const bool is_error = on_missing_asset == OnMissingAsset::kError;
  add(location.prefix(), thing, "wanted ", is_error ? "" : " (left out)", missing_,
      is_error ? errors : notes);
}

void Findings::addMissing(const std::string& thing) { addMissing(SourceLocation(), thing); }

/// Shortens a list of searched folders that was given before for another file.
std::string Findings::shortened(const std::string& thing) {
  const std::size_t begin = thing.find(kSearch);
  if (begin == std::string::npos) return thing;
  const std::string search = thing.substr(begin);
  const bool is_long = search.find(", ") != std::string::npos;  // a single place may be repeated
  if (is_long && isListed(searches_, search)) {
    return thing.substr(0, begin) + "looked in the same folders as above";
  }
  addOnce(searches_, search);
  return thing;
}

void Findings::add(const std::string& location, const std::string& text, const char* times,
                   const std::string& end, Remarks& known, std::vector<std::string>& list) {
  const auto [entry, is_new] = known.try_emplace(text);
  Remark& remark = entry->second;
  if (!remark.locations.insert(location).second) return;
  if (is_new) {
    remark.message = location + shortened(text);
    remark.index = list.size();
    list.push_back(remark.message + end);
    return;
  }
  const std::string model = modelOf(location);
  if (!model.empty() && model != modelOf(remark.message)) addOnce(remark.models, model);
  std::string count = std::to_string(remark.locations.size()) + " times";
  const std::size_t named = std::min(remark.models.size(), kMostModels);
  for (std::size_t i = 0; i < named; ++i) {
    count += (i == 0 ? ", also in " : ", ") + remark.models[i];
  }
  if (remark.models.size() > named) {
    count += " and " + std::to_string(remark.models.size() - named) + " more";
  }
  list[remark.index] = remark.message + " (" + times + count + ")" + end;
}

void Findings::throwErrors() const {
  if (errors.empty()) return;
  if (missing_.empty() || on_missing_asset != OnMissingAsset::kError) throw ErrorList(errors);
  throw MissingAssets(errors, missing_.size());
}

}  // namespace synthetic_dataset::world
