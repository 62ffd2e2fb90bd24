#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "render/edges/edge_pixels.h"
#include "render/edges/edge_smoother.h"
#include "render/lens/lens_sight.h"
#include "render/parts/draw_list.h"

namespace synthetic_dataset::render {

/// Smooths the edges of a picture through a lens, as EdgeSmoother does for a pinhole camera.
/// @param seen  its depths are distances along rays
/// @param edges  the pixels at an edge
/// @param picture  CV_8UC3, blue, green, red, sRGB-encoded, whole
void smoothEdges(const DrawList& draw_list, const EdgeScene& scene, const LensSight& sight,
                 const PictureSamples& seen, const EdgePixels& edges, cv::Mat& picture);

}  // namespace synthetic_dataset::render
