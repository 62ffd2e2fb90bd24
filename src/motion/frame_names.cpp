#include "motion/frame_names.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>

#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kMostSuggestions = 3;

std::string lettersAndDigits(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) plain += static_cast<char>(std::tolower(byte));
  }
  return plain;
}

bool hasPrefixBefore(const std::string& name, const std::string& rest) {
  const std::string end = "/" + rest;
  return !rest.empty() && name.size() > end.size() &&
         name.compare(name.size() - end.size(), end.size(), end) == 0;
}

bool isSameInOtherWriting(const std::string& a, const std::string& b) {
  const std::string plain = lettersAndDigits(a);
  return (!plain.empty() && plain == lettersAndDigits(b)) || hasPrefixBefore(a, b) ||
         hasPrefixBefore(b, a);
}

}  // namespace

std::string withoutLeadingSlashes(const std::string& frame) {
  return frame.substr(std::min(frame.find_first_not_of('/'), frame.size()));
}

std::vector<std::string> framesLike(const std::string& name,
                                    const std::vector<std::string>& frames) {
  const std::string plain = withoutLeadingSlashes(name);
  std::vector<std::string> same;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(same),
               [&](const std::string& frame) { return isSameInOtherWriting(plain, frame); });
  std::sort(same.begin(), same.end());
  same.resize(std::min(same.size(), kMostSuggestions));
  return same;
}

std::string didYouMeanFrame(const std::string& name, const std::vector<std::string>& frames) {
  const std::vector<std::string> same = framesLike(name, frames);
  if (same.empty()) return didYouMean(name, frames);
  std::string choice;
  for (const std::string& frame : same) choice += (choice.empty() ? "'" : " or '") + frame + "'";
  return "; did you mean " + choice + "?";
}

FrameId FrameNames::findOrAdd(const std::string& name) {
  const std::string plain = withoutLeadingSlashes(name);
  const auto [entry, added] = ids_.try_emplace(plain, static_cast<FrameId>(names_.size()));
  if (added) names_.push_back(plain);
  return entry->second;
}

std::optional<FrameId> FrameNames::find(const std::string& name) const {
  const auto entry = ids_.find(withoutLeadingSlashes(name));
  if (entry == ids_.end()) return std::nullopt;
  return entry->second;
}

const std::string& FrameNames::of(FrameId frame) const {
  return names_.at(static_cast<std::size_t>(frame));
}

}  // namespace synthetic_dataset::motion
