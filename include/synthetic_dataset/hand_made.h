#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
inline namespace v2 {

// Hand-made scenes for testing a writer without a world; every value in them is known beforehand.
// TestedWriter passes them to a writer.

/// 640 x 480 px, f = 500 px, principal point (320, 240) px, range 0.05 to 100 m.
[[nodiscard]] CameraModel handMadeCamera();

/// An object with the class "<name>_class", the class number 0 and the id "<name>_id" at
/// p_GO = p_CO = (0, 0, 10) m without rotation. Nothing of it is in view: it has no boxes, no
/// pixels and no keypoints.
[[nodiscard]] SceneObject handMadeObject(const std::string& name);

/// The same object as a cube of one metre that covers these pixels and that nothing hides. Pixels
/// outside the image count as truncated.
/// @param pixels  at least one
[[nodiscard]] SceneObject handMadeObject(const std::string& name, const cv::Rect& pixels);

/// The object without visible pixels; its silhouette stays.
[[nodiscard]] SceneObject hidden(SceneObject object);

/// A scene seen by handMadeCamera() from the global frame's origin along its z axis: a grey image,
/// and everything that can be required except normals, optical flow and clouds, which a test sets
/// itself if it needs them. Its frames are not connected (Scene::setTransforms).
/// @param index  of the scene and its instant
/// @param objects  Scene::objects, in this order; their instances are set. Where visible masks
///     overlap, maps and depth show the later object
[[nodiscard]] Scene handMadeScene(std::int64_t index, std::vector<SceneObject> objects);

/// The dataset of one handMadeScene(), for LabelWriter::initialize: these objects, their classes
/// and the camera "camera".
[[nodiscard]] DatasetInfo handMadeDataset(const std::vector<SceneObject>& objects);

}  // namespace v2
}  // namespace synthetic_dataset
