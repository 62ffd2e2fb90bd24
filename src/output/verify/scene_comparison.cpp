#include "output/verify/scene_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/image/image_encoder.h"
#include "output/files/file_name_rules.h"
#include "output/scene_contents.h"
#include "plugins/readback/files.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::output {
namespace {

std::string kindOf(const cv::Mat& picture) {
  return std::to_string(picture.cols) + " x " + std::to_string(picture.rows) + " pixels of " +
         std::to_string(picture.channels()) + " channels of " +
         std::to_string(8 * picture.elemSize1()) + " bits";
}

/// A file's pixels as they will be read back.
cv::Mat pixelsOf(const OutputFile& file) {
  if (!file.mask.imageSize().empty()) return file.mask.whole();
  if (file.palette.empty()) return file.pixels;
  cv::Mat colours(file.pixels.size(), CV_8UC3);
  for (int row = 0; row < colours.rows; ++row) {
    const auto* indices = file.pixels.ptr<uchar>(row);
    auto* to = colours.ptr<cv::Vec3b>(row);
    for (int column = 0; column < colours.cols; ++column)
      to[column] = file.palette[indices[column]];
  }
  return colours;
}

/// The number of pixels that differ; NaN equals NaN.
std::size_t differing(const cv::Mat& one, const cv::Mat& other) {
  std::size_t count = 0;
  for (int row = 0; row < one.rows; ++row) {
    const std::size_t size = one.elemSize() * static_cast<std::size_t>(one.cols);
    if (std::memcmp(one.ptr(row), other.ptr(row), size) == 0) continue;
    for (std::size_t at = 0; at < size; at += one.elemSize()) {
      count += std::memcmp(one.ptr(row) + at, other.ptr(row) + at, one.elemSize()) == 0 ? 0 : 1;
    }
  }
  return count;
}

/// The greatest difference between values of corresponding pixels.
std::string greatestDifference(const cv::Mat& one, const cv::Mat& other) {
  const double most = cv::norm(one, other, cv::NORM_INF);
  return one.depth() < CV_32F ? std::to_string(std::llround(most)) : fixed(most, 6);
}

bool areAlike(const cv::Mat& one, const cv::Mat& other) {
  return one.size() == other.size() && one.type() == other.type();
}

void comparePixels(const std::string& path, const cv::Mat& right, const std::string& name,
                   formats::Differences& differences) {
  const cv::Mat found = formats::readPicture(path, cv::IMREAD_UNCHANGED);
  if (!areAlike(found, right)) {
    differences.add(name, kindOf(found), kindOf(right));
  } else if (const std::size_t count = differing(found, right); count > 0) {
    differences.add(name + ": " + std::to_string(count) + " of " + std::to_string(right.total()) +
                    " pixels differ, by up to " + greatestDifference(found, right));
  }
}

const OutputFile* fileAt(const std::string& path, const SceneFiles& files) {
  const auto found = std::find_if(files.files.begin(), files.files.end(),
                                  [&](const OutputFile& each) { return each.path == path; });
  return found == files.files.end() ? nullptr : &*found;
}

/// @return  whether it is known what is right
bool compareFile(const RewrittenScene& scene, const OutputFile& right, const OutputFile& other,
                 const std::string& name, SceneDifferences& differences) {
  const bool is_jpeg = base::imageFormat(right.path) == base::ImageFormat::kJpeg;
  if (is_jpeg && scene.drawn_quality) {
    const std::vector<uchar> bytes =
        encodeScene({right}, *scene.drawn_quality, scene.result.files.recorded).front().encoded;
    comparePixels(right.path, cv::imdecode(bytes, cv::IMREAD_UNCHANGED), name,
                  differences.pictures);
    return true;
  }
  const cv::Mat pixels = pixelsOf(right);
  if (pixels.empty()) {
    if (!formats::isText(right.text) && other.text != right.text) return false;
    formats::compareContents(formats::readText(right.path), right.text, name, differences.values,
                             &other.text);
    return true;
  }
  const cv::Mat others = &other == &right ? pixels : pixelsOf(other);
  if (is_jpeg || !areAlike(pixels, others) || differing(pixels, others) > 0) return false;
  comparePixels(right.path, pixels, name, differences.pictures);
  return true;
}

void compareAllRecords(const FoundScene& found, const RewrittenScene& right,
                       formats::Differences& differences) {
  const std::vector<SceneFiles::Record>& records = right.result.files.records;
  const std::vector<SceneFiles::Record>& others =
      right.other ? right.other->files.records : records;
  if (others.size() != records.size()) return;
  if (found.records.size() != records.size()) {
    differences.add("the manifest's records", std::to_string(found.records.size()) + " records",
                    std::to_string(records.size()));
    return;
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::string where =
        "the manifest's record " + std::to_string(i) + " of '" + records[i].channel + "'";
    if (found.records[i].channel != records[i].channel) {
      differences.add(where, "'" + found.records[i].channel + "'", "'" + records[i].channel + "'");
    } else {
      formats::compareRecords(found.records[i].text, records[i].text, where, differences,
                              &others[i].text);
    }
  }
}

void compareWarnings(std::vector<std::string> found, std::vector<std::string> right,
                     formats::Differences& differences) {
  std::sort(found.begin(), found.end());
  std::sort(right.begin(), right.end());
  std::vector<std::string> only;
  std::set_difference(found.begin(), found.end(), right.begin(), right.end(),
                      std::back_inserter(only));
  for (const std::string& each : only) {
    differences.add("the manifest has the warning \"" + each + "\", which it should not have");
  }
  only.clear();
  std::set_difference(right.begin(), right.end(), found.begin(), found.end(),
                      std::back_inserter(only));
  for (const std::string& each : only) {
    differences.add("the manifest lacks the warning \"" + each + "\"");
  }
}

}  // namespace

std::string pathBelow(const std::string& folder, const std::string& path) {
  return liesWithin(path, folder) ? path.substr(folder.size()) : path;
}

SceneDifferences compareScene(const FoundScene& found, const RewrittenScene& right) {
  SceneDifferences differences;
  std::set<std::string> left = found.files;
  for (const OutputFile& each : right.result.files.files) {
    const std::string name = pathBelow(found.folder, each.path);
    const OutputFile* other = right.other ? fileAt(each.path, right.other->files) : &each;
    if (left.erase(each.path) == 0) {
      differences.values.add("there is no file '" + name + "'; it should be there");
    } else if (found.checked.count(each.path) == 0) {
      if (other == nullptr || !compareFile(right, each, *other, name, differences)) {
        differences.unknown = name;
      }
    }
  }
  for (const std::string& path : left) {
    differences.values.add("found the file '" + pathBelow(found.folder, path) +
                           "', which the writer does not make");
  }
  compareAllRecords(found, right, differences.values);
  if (!right.other || right.other->warnings == right.result.warnings) {
    compareWarnings(found.warnings, right.result.warnings, differences.values);
  }
  return differences;
}

}  // namespace synthetic_dataset::output
