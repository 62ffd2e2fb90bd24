#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/format.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {

/// The files of a scene, and what a format's reader finds in them.
class ReaderTest : public testing::Test {
 protected:
  /// @param format  "Yolo"
  explicit ReaderTest(const std::string& format)
      : format_(formatOf("synthetic_dataset/" + format)) {}

  std::filesystem::path picture(const std::string& path, const cv::Mat& pixels) const {
    const auto file = folder_.write(path, "");
    cv::imwrite(file.string(), pixels);
    return file;
  }

  std::filesystem::path image(const std::string& path, const cv::Size& size = {100, 80}) const {
    return picture(path, cv::Mat(size, CV_8UC3, cv::Scalar::all(9)));
  }

  [[nodiscard]] LabelledPicture readScene(const std::vector<std::filesystem::path>& files,
                                          const std::string& name = "00000000") const {
    return readScene(files, name, {});
  }

  /// @param settings  of the writer
  [[nodiscard]] LabelledPicture readScene(const std::vector<std::filesystem::path>& files,
                                          const std::string& name,
                                          const Value::Map& settings) const {
    WrittenScene scene{folder_.path(), name, 0, Stamp{0}, files};
    scene.settings = settings;
    return format_->read(scene);
  }

  /// Whether one of a label's lines goes from one point to the other, either way.
  [[nodiscard]] static bool hasLine(const DrawnLabel& label, const cv::Point2d& a,
                                    const cv::Point2d& b) {
    const auto isNear = [](const cv::Point2d& p, const cv::Point2d& q) {
      return cv::norm(p - q) < 1e-6;
    };
    for (const auto& [from, to] : label.lines) {
      if ((isNear(from, a) && isNear(to, b)) || (isNear(from, b) && isNear(to, a))) return true;
    }
    return false;
  }

  test::TemporaryFolder folder_;

 private:
  const Format* format_;
};

}  // namespace synthetic_dataset::formats
