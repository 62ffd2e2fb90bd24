#pragma once

#include <string>
#include <vector>

#include "plugins/readback/drawn_label.h"
#include "plugins/readback/expected_labels.h"

namespace synthetic_dataset::output {

/// What is wrong with the labels that a format's files have of a scene, a line each: one that
/// differs from what the measures say, one that should not be there, one that lacks.
[[nodiscard]] std::vector<std::string> labelProblems(const formats::LabelledPicture& picture,
                                                     const formats::ExpectedLabels& expected);

}  // namespace synthetic_dataset::output
