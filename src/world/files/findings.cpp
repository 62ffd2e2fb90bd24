#include "world/files/findings.h"

#include <algorithm>

namespace synthetic_dataset::world {
namespace {

constexpr const char* kNoSuchFile = ": no such file";
constexpr const char* kSearch = "looked in ";

/// Models that a message names of those that want a file, too.
constexpr std::size_t kMostModels = 5;

bool isListed(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

void addOnce(std::vector<std::string>& list, const std::string& message) {
  if (!isListed(list, message)) list.push_back(message);
}

/// Of "<place>: mesh 'x.dae': no such file; ..." what comes after the place; else all of it.
std::string thingOf(const std::string& message) {
  const std::size_t end = message.find(kNoSuchFile);
  if (end == std::string::npos || end == 0) return message;
  const std::size_t place_end = message.rfind(": ", end - 1);
  return place_end == std::string::npos ? message : message.substr(place_end + 2);
}

/// "model 'shelf'" of a message about what is in it; nothing of others.
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

std::vector<std::string>& Findings::missingList() {
  return on_missing_asset == OnMissingAsset::kError ? errors : notes;
}

std::string Findings::shortened(const std::string& message) {
  const std::size_t begin = message.find(kSearch);
  if (begin == std::string::npos || message.find(kNoSuchFile) > begin) return message;
  const std::string search = message.substr(begin);
  const bool is_long = search.find(", ") != std::string::npos;  // one place says itself
  if (is_long && isListed(searches_, search)) {
    return message.substr(0, begin) + "looked in the same folders as above";
  }
  addOnce(searches_, search);
  return message;
}

void Findings::countAgain(Missing& missing, const std::string& message) {
  if (!missing.messages.insert(message).second) return;
  const std::string model = modelOf(message);
  if (!model.empty() && model != modelOf(missing.message)) addOnce(missing.models, model);
  std::string text =
      missing.message + " (wanted " + std::to_string(missing.messages.size()) + " times";
  const std::size_t named = std::min(missing.models.size(), kMostModels);
  for (std::size_t i = 0; i < named; ++i) {
    text += (i == 0 ? ", also in " : ", ") + missing.models[i];
  }
  if (missing.models.size() > named) {
    text += " and " + std::to_string(missing.models.size() - named) + " more";
  }
  const bool left_out = on_missing_asset == OnMissingAsset::kWarn;
  missingList()[missing.index] = text + ")" + (left_out ? " (left out)" : "");
}

void Findings::addMissing(const std::string& message) {
  const std::string thing = thingOf(message);
  const auto known = std::find_if(missing_.begin(), missing_.end(),
                                  [&](const Missing& each) { return each.thing == thing; });
  if (known != missing_.end()) {
    if (thing != message) countAgain(*known, message);
    return;
  }
  const std::string text = shortened(message);
  missing_.push_back({thing, text, missingList().size(), {message}, {}});
  missingList().push_back(text + (on_missing_asset == OnMissingAsset::kWarn ? " (left out)" : ""));
}

void Findings::throwErrors() const {
  if (errors.empty()) return;
  if (missing_.empty() || on_missing_asset != OnMissingAsset::kError) throw ErrorList(errors);
  throw MissingAssets(errors, missing_.size());
}

}  // namespace synthetic_dataset::world
