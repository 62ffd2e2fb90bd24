#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include <geometry_msgs/TransformStamped.h>

#include "motion/bag/bag_check.h"
#include "motion/tf/left_out_transforms.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// The order in which messages arrived: by record time, but within a bag by their order in the
/// file. When a simulation is reset, record times of its clock go back, whereas the file only moves
/// forward.
struct Arrival {
  Stamp not_before{0};  ///< the bag's latest record time up to this message
  std::uint32_t bag = 0;
  MessagePlace place = 0;

  [[nodiscard]] bool operator<(const Arrival& other) const {
    return std::tie(not_before, bag, place) < std::tie(other.not_before, other.bag, other.place);
  }
};

/// A transform, and how it was recorded.
struct RecordedTransform {
  geometry_msgs::TransformStamped transform;
  TransformKind kind = TransformKind::kMoving;
  std::string bag_file;
  Stamp recorded{0};
  Arrival arrival;
  std::string publisher;  ///< the node's name; empty if the bag does not say
};

}  // namespace synthetic_dataset::motion
