#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <opencv2/core/types.hpp>

#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
inline namespace v2 {

// Scenes made by hand, to test a writer without a world: each measure of them is known beforehand.
// TestedWriter gives them to a writer.

/// 640 x 480 px, f = 500 px, its centre at (320, 240) px, from 0.05 to 100 m.
[[nodiscard]] CameraModel handMadeCamera();

/// An object of the class "<name>_class" with the number 0 and the id "<name>_id" at
/// p_GO = p_CO = (0, 0, 10) m without turn. Nothing of it is in view: it has no boxes, no pixels
/// and no keypoints.
[[nodiscard]] SceneObject handMadeObject(const std::string& name);

/// The same with all measures of a cube of one metre that covers these pixels and that nothing
/// hides. What of them lies outside of the image is truncated.
/// @param pixels  at least one
[[nodiscard]] SceneObject handMadeObject(const std::string& name, const cv::Rect& pixels);

/// The object as one of which no pixel is visible; its silhouette stays.
[[nodiscard]] SceneObject hidden(SceneObject object);

/// A scene of handMadeCamera(), which looks along the global frame's z axis from its origin: a grey
/// image, and all that can be required but normals, optical flow and clouds, which a test sets
/// where it wants them. Its frames are not connected (Scene::setTransforms).
/// @param index  of the scene and its instant
/// @param objects  Scene::objects, in this order; their instances are set. Where visible masks
///     overlap, maps and depth show the later object
[[nodiscard]] Scene handMadeScene(std::int64_t index, std::vector<SceneObject> objects);

/// The dataset of one handMadeScene(), for LabelWriter::initialize: these objects, their classes
/// and the camera "camera".
[[nodiscard]] DatasetInfo handMadeDataset(const std::vector<SceneObject>& objects);

}  // namespace v2
}  // namespace synthetic_dataset
