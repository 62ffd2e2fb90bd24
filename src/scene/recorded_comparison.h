#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/scene_facts.h"
#include "label/occlusion.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::scene {

/// Measures how well a scene's outlines meet the edges of its recorded picture.
void compareWithRecorded(const cv::Mat& recorded, const Scene& scene, base::SceneFacts& facts);

/// Whether a scene's labels fit its recorded picture too badly; the facts get a warning then.
/// @param least  twin/min_alignment
[[nodiscard]] bool isBelowAlignment(double least, base::SceneFacts& facts);

/// Notes for how many of the objects' pixels it is unknown whether something hides them.
/// @param covers  of each object; empty where nothing was measured: then all are unknown
void addCovers(const std::vector<label::ObjectCover>& covers, const Scene& scene,
               base::SceneFacts& facts);

}  // namespace synthetic_dataset::scene
