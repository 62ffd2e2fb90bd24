#pragma once

#include <cstdint>
#include <string>
#include <tuple>

#include <geometry_msgs/TransformStamped.h>

#include "motion/bag/bag_check.h"
#include "motion/tf/left_out_transforms.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// When a message came, compared with others: by record time, but within a bag as they lie in the
/// file. The record times of a simulation's clock go back when it is reset, the file does not.
struct Arrival {
  Stamp not_before{0};  ///< the latest record time of the bag up to it
  std::uint32_t bag = 0;
  MessagePlace place = 0;

  [[nodiscard]] bool operator<(const Arrival& other) const {
    return std::tie(not_before, bag, place) < std::tie(other.not_before, other.bag, other.place);
  }
};

/// A transform, and how it came.
struct RecordedTransform {
  geometry_msgs::TransformStamped transform;
  TransformKind kind = TransformKind::kMoving;
  std::string bag_file;
  Stamp recorded{0};
  Arrival arrival;
  std::string publisher;  ///< the node's name; empty where the bag does not say
};

}  // namespace synthetic_dataset::motion
