#include "world/files/findings.h"

#include <algorithm>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

void addOnce(std::vector<std::string>& list, const std::string& message) {
  if (std::find(list.begin(), list.end(), message) == list.end()) list.push_back(message);
}

}  // namespace

void Findings::addError(const std::string& message) { addOnce(errors, message); }

void Findings::addNote(const std::string& message) { addOnce(notes, message); }

void Findings::addMissing(const std::string& message) {
  if (on_missing_asset == OnMissingAsset::kError) {
    addError(message);
  } else {
    addNote(message + " (left out)");
  }
}

void Findings::throwErrors() const {
  if (!errors.empty()) throw ErrorList(errors);
}

}  // namespace synthetic_dataset::world
