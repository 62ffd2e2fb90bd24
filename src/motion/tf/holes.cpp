#include "motion/tf/holes.h"

#include <algorithm>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::motion {
namespace {

std::string scenesText(std::int64_t count) {
  return std::to_string(count) + (count == 1 ? " scene" : " scenes");
}

std::string secondsOf(Duration time) {
  constexpr int kDecimals = 3;
  return fixed(toSeconds(time), kDecimals) + " s";
}

}  // namespace

Duration longestGapOf(const LinkHistory& link) {
  constexpr Duration kLeast = std::chrono::seconds(10);
  constexpr int kPeriods = 20;
  return std::max(kLeast, kPeriods * link.medianPeriod());
}

bool Holes::forbid(const std::set<FrameId>& links, Stamp time) {
  bool is_forbidden = false;
  for (const FrameId child : links) {
    const LinkHistory& link = tree_.link(child);
    const auto gap = link.gapAt(time);
    if (!gap) continue;
    const Duration usual = longestGapOf(link);
    const Duration longest = options_.max_tf_gap.value_or(usual);
    if (gap->length() <= std::min(longest, usual)) continue;
    Hole& hole = holes_.try_emplace({child, gap->from}, Hole{*gap}).first->second;
    hole.is_forbidden = gap->length() > longest && !gap->is_still;
    ++hole.scenes;
    is_forbidden = is_forbidden || hole.is_forbidden;
  }
  return is_forbidden;
}

std::string Holes::message(FrameId child, const Hole& hole) const {
  std::string text = "TF has nothing of the frame '" + tree_.names().of(child) + "' from " +
                     secondsOf(hole.gap.from) + " to " + secondsOf(hole.gap.until) + " (" +
                     secondsOf(hole.gap.length()) + "): " + scenesText(hole.scenes) +
                     " in between ";
  const std::string verb = hole.scenes == 1 ? "is " : "are ";
  if (hole.is_forbidden) {
    return text + verb + "left out (max_tf_gap: .inf makes " + (hole.scenes == 1 ? "it" : "them") +
           ")";
  }
  if (hole.gap.is_still) return text + verb + "made, as its pose is the same before and after";
  return text + verb + "made, its poses interpolated across, as max_tf_gap allows";
}

void Holes::report(base::Diagnostics& diagnostics) const {
  constexpr std::int64_t kMost = 5;  // of a frame
  std::map<FrameId, std::int64_t> counts;
  std::map<FrameId, std::int64_t> scenes_of_others;
  for (const auto& [place, hole] : holes_) {
    if (++counts[place.first] <= kMost) {
      diagnostics.warning("", message(place.first, hole));
    } else {
      scenes_of_others[place.first] += hole.scenes;
    }
  }
  for (const auto& [child, scenes] : scenes_of_others) {
    diagnostics.warning("", "TF has " + std::to_string(counts[child] - kMost) +
                                " more such holes of the frame '" + tree_.names().of(child) +
                                "', with " + scenesText(scenes));
  }
}

}  // namespace synthetic_dataset::motion
