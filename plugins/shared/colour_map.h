#pragma once

#include <vector>

#include <opencv2/core/matx.hpp>

namespace synthetic_dataset {

/// Pascal VOC's 256 colours, blue green red: black first, neighbours clearly different. The
/// development kit's VOClabelcolormap.m defines them: a number's bits go, three at a time, to red,
/// green and blue, filling these from the highest bit down.
/// http://host.robots.ox.ac.uk/pascal/VOC/voc2012/#devkit
[[nodiscard]] std::vector<cv::Vec3b> vocColourMap();

}  // namespace synthetic_dataset
