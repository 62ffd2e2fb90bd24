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

/// How different that is which a network would otherwise learn by heart.
///
/// What else was tried does not order datasets as networks do that learnt from them and see
/// photographs: docs/report.md.
struct SceneVariety {
  double detail = 0.0;                       ///< share of what surrounds labels that is not plain
  std::map<std::string, std::size_t> looks;  ///< models and their variants, by class
};

/// The share of what surrounds an image's labels that differs from a neighbour by more than 8 of
/// 255, in an image that is made 64 px wide: it has neither a sensor's noise nor the grain of a
/// ground. Nothing where there is no image, or labels fill it.
[[nodiscard]] std::optional<double> surroundingDetail(const Scene& scene);

/// Of some scenes with visible masks; nothing where they have no labels, or labels fill all
/// images.
[[nodiscard]] std::optional<SceneVariety> varietyOf(const RunSetup& setup,
                                                    const std::vector<FinishedScene>& scenes);

/// One line of text.
[[nodiscard]] std::string varietyLine(const SceneVariety& variety);

/// Warns of pictures of one model on one plain ground.
[[nodiscard]] std::vector<Finding> checkVariety(const SceneVariety& variety);

}  // namespace synthetic_dataset::run
