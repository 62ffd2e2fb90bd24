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

/// Groups of links by name: patterns of what is meant, in which `*` and `?` stand for any text and
/// any character.
using LinkGroups = std::map<std::string, std::vector<std::string>>;

/// Classes of what no object is: patterns of models' names ("wall_*") or of links ("house::roof"),
/// or the numbers that gz-sim's label plugins give them.
using WorldClasses = LinkGroups;

/// Which TF frame each link of an object has.
struct LinkFrames {
  std::string pattern = "{object}/{link}";     ///< for all links
  std::map<std::string, std::string> by_link;  ///< where not empty: these frames, and no others
};

/// What becomes of a recording's scenes at whose time an object's frame is not known.
enum class WhenUnknown {
  kSkipScene,  ///< they are not made
  kAbsent,     ///< they are made without the object
};

struct ObjectOptions {
  std::string name;
  std::string class_text;       ///< `class` as text: a name, or a class's number
  std::string class_name;       ///< of its class in the dataset's classes
  int class_id = 0;             ///< of its class in the dataset's classes
  std::string id;               ///< `id` as text
  bool takes_part = true;       ///< in this motion, where its frame is
  bool is_distractor = false;   ///< put somewhere now and then; these come last
  std::string frame;            ///< `frame`, else "<name>/<frame_id>"
  bool frame_is_given = false;  ///< as a whole, by `frame`
  WhenUnknown when_unknown = WhenUnknown::kSkipScene;
  LinkFrames link_frames;            ///< of an articulated model
  bool stands = false;               ///< in the world; its frame is a name of our own then
  std::optional<Pose> X_GM;          ///< where it stands; none: where the world has its model
  std::optional<std::string> model;  ///< its model, the URI of it or its text; none: the world's
                                     ///< model of its name
  std::map<std::string, std::string> model_arguments;  ///< of a xacro file
  std::vector<Eigen::Vector3d> keypoints_O;
  std::vector<std::string> keypoint_names;           ///< none: numbers
  std::vector<std::array<std::size_t, 2>> skeleton;  ///< pairs of keypoints, from 0
  int farthest_points = 0;  ///< how many keypoints are chosen on the model instead; 0: as given
  LinkGroups parts;         ///< of its links
  std::vector<Eigen::Vector3d> bounding_shape_O;  ///< none: the model's own box
  std::optional<double>
      safety_radius;  ///< kept free around it when it is placed [m]; none: its own
};

}  // namespace synthetic_dataset::scene
