#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/scene_facts.h"
#include "label/occlusion.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::scene {

/// Measures how well a scene's outlines meet the edges of its recorded picture.
void compareWithRecorded(const cv::Mat& recorded, const Scene& scene, base::SceneFacts& facts);

/// Whether a scene's labels fit its recorded picture too badly; if so, a warning is added to the
/// facts.
/// @param least  twin/min_alignment
[[nodiscard]] bool isBelowAlignment(double least, base::SceneFacts& facts);

/// Records for what share of the objects' pixels it is unknown whether something hides them, and
/// what share is hidden.
/// @param covers  of each object; empty if nothing was measured: then all pixels are unknown
void addCovers(const std::vector<label::ObjectCover>& covers, const Scene& scene,
               base::SceneFacts& facts);

}  // namespace synthetic_dataset::scene
