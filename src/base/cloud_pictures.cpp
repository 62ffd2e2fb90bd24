#include "base/cloud_pictures.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace synthetic_dataset::base {

std::map<std::string, cv::Mat> cloudPictures(const Clouds& clouds) {
  std::map<std::string, cv::Mat> pictures;
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const std::vector<CloudPoint>& points = clouds[i]->points;
    const int count = static_cast<int>(points.size());
    cv::Mat_<cv::Vec4f> at_stamp(count, 1);
    cv::Mat_<cv::Vec4f> measured(count, 1);
    cv::Mat_<cv::Vec3w> labels(count, 1);
    for (int row = 0; row < count; ++row) {
      const CloudPoint& p = points[static_cast<std::size_t>(row)];
      const Eigen::Vector3f& a = p.position_at_stamp_S;
      const Eigen::Vector3f& m = p.position_S;
      at_stamp(row) = {a.x(), a.y(), a.z(), p.intensity};
      measured(row) = {m.x(), m.y(), m.z(), p.intensity};
      labels(row) = {p.instance, p.class_number, p.world_class};
    }
    const std::string name = "cloud_" + std::to_string(i);
    pictures[name] = at_stamp;
    pictures[name + "_measured"] = measured;
    pictures[name + "_labels"] = labels;
  }
  return pictures;
}

}  // namespace synthetic_dataset::base
