#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <sensor_msgs/PointCloud2.h>
#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::test {

enum class Compression { kNone, kBz2, kLz4 };

/// A pose turned about z only: position [m], yaw [rad].
[[nodiscard]] Pose poseAt(double x, double y, double z, double yaw = 0.0);

/// A time in whole milliseconds since the epoch.
[[nodiscard]] inline Stamp milliseconds(std::int64_t count) {
  return std::chrono::milliseconds(count);
}

/// Writes a tiny bag in a line or two:
///   BagBuilder(file).move("map", "a", milliseconds(1000), poseAt(1, 0, 0)).close();
class BagBuilder {
 public:
  explicit BagBuilder(const std::filesystem::path& file,
                      Compression compression = Compression::kNone);
  ~BagBuilder();
  BagBuilder(const BagBuilder&) = delete;
  BagBuilder& operator=(const BagBuilder&) = delete;

  /// A transform on `/tf`, recorded at its stamp.
  BagBuilder& move(const std::string& parent, const std::string& child, Stamp stamp,
                   const Pose& X_PC = Pose::Identity());

  /// A transform on `/tf_static`, recorded at its stamp.
  BagBuilder& fix(const std::string& parent, const std::string& child, Stamp stamp,
                  const Pose& X_PC = Pose::Identity());

  /// A transform with every detail: the quaternion is written as it is.
  struct Transform {
    std::string topic = "/tf";
    std::string parent, child;
    Stamp stamp{0};
    Stamp recorded{0};
    double x = 0.0, y = 0.0, z = 0.0;
    double qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;
    std::string publisher = {};  ///< the node that sent it; if empty, the bag does not name it
  };
  BagBuilder& add(const Transform& transform);

  /// A nav_msgs/Odometry, recorded at its stamp.
  BagBuilder& drive(const std::string& topic, const std::string& parent, const std::string& child,
                    Stamp stamp, const Pose& X_PC);

  /// A geometry_msgs/PoseStamped, recorded at its stamp.
  BagBuilder& locate(const std::string& topic, const std::string& parent, Stamp stamp,
                     const Pose& X_PC);

  /// A geometry_msgs/PoseArray, recorded at its stamp.
  BagBuilder& locateAll(const std::string& topic, const std::string& parent, Stamp stamp,
                        const std::vector<Pose>& poses);

  /// A sensor_msgs/JointState, recorded at its stamp.
  BagBuilder& bend(const std::string& topic, Stamp stamp,
                   const std::map<std::string, double>& positions);

  /// A gazebo_msgs/ModelStates or LinkStates, in the world's frame.
  BagBuilder& simulate(const std::string& topic, const std::string& type, Stamp recorded,
                       const std::map<std::string, Pose>& X_WM);

  /// A std_msgs/String.
  BagBuilder& say(const std::string& topic, Stamp recorded, const std::string& text = "hello");

  /// A sensor_msgs/CameraInfo of 160 x 120 pixels with the given focal length [px] and plumb_bob
  /// distortion.
  BagBuilder& calibrate(const std::string& topic, const std::string& frame, Stamp recorded,
                        double focal_length, const std::vector<double>& distortion = {});

  /// From now on, calibrations are for images of this size [px], with the principal point in the
  /// middle.
  BagBuilder& resizeCamera(std::uint32_t width, std::uint32_t height);

  /// A sensor_msgs/Image of these pixels, recorded at its stamp.
  /// @param encoding  a name in sensor_msgs/image_encodings.h that fits the pixels' type
  BagBuilder& picture(const std::string& topic, Stamp stamp, const cv::Mat& pixels,
                      const std::string& encoding);

  /// From now on, pictures, depth images and clouds have this frame.
  BagBuilder& from(const std::string& frame);

  /// A sensor_msgs/PointCloud2 with 32-bit float coordinates, recorded at its stamp.
  BagBuilder& cloud(const std::string& topic, Stamp stamp,
                    const std::vector<Eigen::Vector3d>& points);

  /// The given sensor_msgs/PointCloud2 as it is, recorded at its stamp.
  BagBuilder& cloud(const std::string& topic, const sensor_msgs::PointCloud2& message);

  /// A picture of one grey pixel whose stamp differs from its record time.
  BagBuilder& pictureAt(const std::string& topic, Stamp recorded, Stamp stamp);

  /// A sensor_msgs/CompressedImage, recorded at its stamp.
  BagBuilder& pictureFile(const std::string& topic, Stamp stamp, const std::string& format,
                          const std::vector<std::uint8_t>& bytes);

  /// A map in cells.
  struct Map {
    std::string topic = "/map";
    std::string frame = "map";
    Stamp recorded{0};
    std::uint32_t width = 0;   ///< [cells]
    std::uint32_t height = 0;  ///< [cells]
    float resolution = 0.5F;   ///< [m]
    Pose X_FM = Pose::Identity();
    std::vector<std::int8_t> cells;
  };
  /// A nav_msgs/OccupancyGrid, as it is.
  BagBuilder& map(const Map& map);

  /// From now on, each message goes into a chunk of its own; long recordings have many chunks.
  BagBuilder& splitChunks();

  /// Completes the file and returns its name.
  std::string close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace synthetic_dataset::test
