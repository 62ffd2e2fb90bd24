#include "scene/recorded_comparison.h"

#include <cstdint>
#include <optional>

#include "base/seconds.h"
#include "label/alignment.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {

void compareWithRecorded(const cv::Mat& recorded, const Scene& scene, base::SceneFacts& facts) {
  const std::vector<label::Alignment> alignments = label::alignmentsOf(scene, recorded);
  label::Alignment all;
  for (std::size_t i = 0; i < alignments.size(); ++i) {
    facts.objects[i].alignment = alignments[i].score();
    all += alignments[i];
  }
  facts.alignment = all.score();
}

bool isBelowAlignment(double least, base::SceneFacts& facts) {
  if (facts.alignment.value_or(1.0) >= least) return false;
  facts.warnings.push_back(
      {"scene left out: its alignment is below twin/min_alignment",
       "of " + fixed(*facts.alignment, 3) + " at " + fixed(toSeconds(facts.stamp), 3) + " s"});
  return true;
}

void addCovers(const std::vector<label::ObjectCover>& covers, const Scene& scene,
               base::SceneFacts& facts) {
  label::ObjectCover all;
  const auto sharesOf = [](const label::ObjectCover& cover) {
    return cover.pixels == 0
               ? std::nullopt
               : std::optional(base::CoverFacts{cover.unmeasuredShare(), cover.coveredShare()});
  };
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::int64_t pixels = scene.objects[i].visible_mask().count();
    const label::ObjectCover cover =
        covers.empty() ? label::ObjectCover{pixels, pixels} : covers[i];
    facts.objects[i].cover = sharesOf(cover);
    all += cover;
  }
  facts.cover = sharesOf(all);
}

}  // namespace synthetic_dataset::scene
