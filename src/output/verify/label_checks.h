#pragma once

#include <string>
#include <vector>

#include "output/manifest/picture_facts.h"
#include "output/manifest/run_description.h"
#include "plugins/readback/drawn_label.h"

namespace synthetic_dataset::output {

/// How a scene's labels in a format's files differ from those in the right files, in words: a line
/// for each label that is wrong, unexpected or missing.
/// @param facts, run  what the manifest holds about the scene and its objects, to name them
[[nodiscard]] std::vector<std::string> labelProblems(const formats::LabelledPicture& found,
                                                     const formats::LabelledPicture& right,
                                                     const SceneFacts& facts,
                                                     const RunDescription& run);

/// How the time, the poses and the pixels that the manifest holds for a scene differ from those of
/// a new rendering.
[[nodiscard]] std::vector<std::string> poseProblems(const SceneFacts& found,
                                                    const SceneFacts& drawn,
                                                    const RunDescription& run);

}  // namespace synthetic_dataset::output
