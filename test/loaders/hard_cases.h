#pragma once

#include "loaders/loader_dataset.h"

namespace synthetic_dataset::test {

/// Each time is one of the cases in which labels go wrong: objects that are partly or wholly out of
/// the image, hidden, around the camera, one pixel large, seen through another, touching their
/// like, articulated.
[[nodiscard]] LoaderDataset hardCases();

/// The same through a lens that distorts.
[[nodiscard]] LoaderDataset hardCasesThroughLens();

/// Nothing is in view.
[[nodiscard]] LoaderDataset emptyScenes();

/// Three hundred objects at a time, so that their numbers do not fit into eight bits.
[[nodiscard]] LoaderDataset manyObjects();

/// Two cameras, and scenes in the splits train, val and test.
[[nodiscard]] LoaderDataset camerasAndSplits();

/// A lidar beside the camera, which it sees farther around, in two splits; everything stands.
[[nodiscard]] LoaderDataset lidarScenes();

/// A lidar that rides on an object through a tunnel, and turns.
[[nodiscard]] LoaderDataset movingLidar();

/// Cars, pedestrians and cones before a lidar, elsewhere each time, with the names by which
/// nuScenes and KITTI evaluate them: enough to train on, and to count recall in.
[[nodiscard]] LoaderDataset streets();

}  // namespace synthetic_dataset::test
