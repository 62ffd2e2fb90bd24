#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "run/check/finding.h"
#include "run/scene_sink.h"
#include "run/setup/run_setup.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// How varied those aspects are that a network would otherwise memorize.
///
/// Other measures that were tried do not rank datasets like the performance on photographs of
/// networks trained on them: docs/report.md.
struct SceneVariety {
  double detail = 0.0;  ///< share of the labels' surroundings that is not plain
  std::map<std::string, std::size_t> looks;  ///< number of models and variants, by class
};

/// The share of pixels around an image's labels that differ from a neighbour by more than 8 of 255,
/// in an image scaled to a width of 64 px, which removes sensor noise and fine ground texture.
/// Nothing if there is no image, or if labels fill it.
[[nodiscard]] std::optional<double> surroundingDetail(const Scene& scene);

/// The variety of some scenes with visible masks; nothing if they have no labels, or if labels fill
/// all images.
[[nodiscard]] std::optional<SceneVariety> varietyOf(const RunSetup& setup,
                                                    const std::vector<FinishedScene>& scenes);

/// One line of text.
[[nodiscard]] std::string varietyLine(const SceneVariety& variety);

/// Warns of pictures that all show one model on one plain ground.
[[nodiscard]] std::vector<Finding> checkVariety(const SceneVariety& variety);

}  // namespace synthetic_dataset::run
