/// A node that publishes a map, latched, as map_server does; for live_map_test.py.
///
///   publish_map TOPIC [FRAME]

#include <algorithm>

#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>

namespace {

/// The middle of the example's hall: 4 x 4 m, free but for a strip.
nav_msgs::OccupancyGrid hall(const std::string& frame) {
  constexpr std::uint32_t kSide = 80;
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = frame;
  map.info.resolution = 0.05F;
  map.info.width = map.info.height = kSide;
  map.info.origin.position.x = map.info.origin.position.y = -2.0;
  map.info.origin.orientation.w = 1.0;
  map.data.assign(kSide * kSide, 0);
  std::fill_n(map.data.begin(), 2 * kSide, std::int8_t{100});
  return map;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "publish_map");
  if (argc < 2) return 1;
  ros::NodeHandle node;
  const bool latched = true;
  const auto publisher = node.advertise<nav_msgs::OccupancyGrid>(argv[1], 1, latched);
  publisher.publish(hall(argc > 2 ? argv[2] : "map"));
  ros::spin();
}
