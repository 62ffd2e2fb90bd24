#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// Named groups of links, given by patterns in which `*` matches any text and `?` any character.
using LinkGroups = std::map<std::string, std::vector<std::string>>;

/// Classes of everything that is not an object: patterns of model names ("wall_*") or of links
/// ("house::roof"), or the numbers that gz-sim's label plugins assign.
using WorldClasses = LinkGroups;

/// The TF frame of each link of an object.
struct LinkFrames {
  std::string pattern = "{object}/{link}";     ///< for all links
  std::map<std::string, std::string> by_link;  ///< if not empty: only these frames
};

/// What happens to scenes of a recording at times at which an object's frame is not known.
enum class WhenUnknown {
  kSkipScene,  ///< they are not made
  kAbsent,     ///< they are made without the object
};

struct ObjectOptions {
  std::string name;
  std::string class_text;       ///< `class` as text: a class name or number
  std::string class_name;       ///< of its class in the dataset's classes
  int class_id = 0;             ///< of its class in the dataset's classes
  std::string id;               ///< `id` as text
  bool takes_part = true;       ///< in this motion, in which it then has a frame
  bool is_distractor = false;   ///< placed in some scenes only; distractors come last
  std::string frame;            ///< `frame`, or else "<name>/<frame_id>"
  bool frame_is_given = false;  ///< as a whole, by `frame`
  WhenUnknown when_unknown = WhenUnknown::kSkipScene;
  LinkFrames link_frames;            ///< of an articulated model
  bool stands = false;               ///< in the world; its frame then has a made-up name
  std::optional<Pose> X_GM;          ///< its fixed pose; none: that of its model in the world
  std::optional<std::string> model;  ///< its model, a URI or the text itself; none: the world's
                                     ///< model of the same name
  std::map<std::string, std::string> model_arguments;  ///< of a xacro file
  std::vector<Eigen::Vector3d> keypoints_O;
  std::vector<std::string> keypoint_names;           ///< empty: numbers
  std::vector<std::array<std::size_t, 2>> skeleton;  ///< pairs of keypoints, from 0
  int farthest_points = 0;  ///< number of keypoints to choose on the model; 0: as given
  LinkGroups parts;         ///< of its links
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< empty: the model's own box
  std::optional<double>
      safety_radius;  ///< kept free around it when it is placed [m]; none: its own
};

}  // namespace synthetic_dataset::scene
