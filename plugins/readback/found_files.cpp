#include "plugins/readback/found_files.h"

#include <system_error>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/json_file.h"

namespace synthetic_dataset::formats {
namespace {

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string kindOf(const cv::Mat& picture) {
  return std::to_string(picture.cols) + " x " + std::to_string(picture.rows) + " pixels of " +
         std::to_string(picture.channels()) + " channels of " +
         std::to_string(8 * picture.elemSize1()) + " bits";
}

/// How many pixels differ.
int differing(const cv::Mat& one, const cv::Mat& other) {
  const cv::Mat different = one.reshape(1) != other.reshape(1);
  return cv::countNonZero(different);
}

}  // namespace

ValueCheck::~ValueCheck() = default;

FoundFiles::FoundFiles(std::filesystem::path folder, const std::vector<std::string>& names,
                       DigestOfPixels digest_of_pixels, DigestOfBytes digest_of_bytes,
                       std::shared_ptr<KeptFiles> kept)
    : folder_(std::move(folder)),
      left_(names.begin(), names.end()),
      digest_of_pixels_(std::move(digest_of_pixels)),
      digest_of_bytes_(std::move(digest_of_bytes)),
      kept_(std::move(kept)) {}

std::optional<std::filesystem::path> FoundFiles::take(const std::string& name) {
  if (left_.erase(name) != 0) return folder_ / name;
  differences_.add("there is no file '" + name + "'; it should be there");
  return std::nullopt;
}

void FoundFiles::compareJson(const std::string& name, const nlohmann::json& right) {
  const auto file = take(name);
  if (!file) return;
  readJson(*file, [&](const nlohmann::json& found) {
    formats::compareJson(found, right, name, differences_);
  });
}

void FoundFiles::compareText(const std::string& name, const std::string& right) {
  const auto file = take(name);
  if (file) formats::compareText(readText(*file), right, name, differences_);
}

void FoundFiles::comparePicture(const std::string& name, const cv::Mat& right) {
  const auto file = take(name);
  if (!file) return;
  const cv::Mat found = readPicture(*file, cv::IMREAD_UNCHANGED);
  if (found.size() != right.size() || found.type() != right.type()) {
    differences_.add(name, kindOf(found), kindOf(right));
  } else if (const int count = differing(found, right); count > 0) {
    differences_.add(name + ": found " + std::to_string(count) + " wrong values of pixels");
  }
}

void FoundFiles::compareMask(const std::string& name, const Mask& right) {
  comparePicture(name, right.whole());
}

void FoundFiles::compareWithScene(const std::string& name, const TrueScene& scene,
                                  const std::string& picture) {
  const auto file = take(name);
  if (!file) return;
  if (endsWith(name, ".jpg")) {
    compareDigest(name, digest_of_bytes_(readText(*file)), scene, picture + ".jpg");
  } else {
    comparePixels(name, readPicture(*file, cv::IMREAD_UNCHANGED), scene, picture);
  }
}

void FoundFiles::comparePixels(const std::string& name, const cv::Mat& found,
                               const TrueScene& scene, const std::string& picture) {
  compareDigest(name, digest_of_pixels_(found), scene, picture);
}

void FoundFiles::compareDigest(const std::string& name, const std::string& found,
                               const TrueScene& scene, const std::string& picture) {
  const auto right = scene.digests.find(picture);
  if (right == scene.digests.end()) {
    differences_.add(name + ": the manifest does not say what is in it");
  } else if (found != right->second) {
    differences_.add(name + ": its pixels are not those of the scene's " + picture);
  }
}

void FoundFiles::compareBytes(const std::string& name, const std::filesystem::path& other) {
  const auto file = take(name);
  std::error_code error;
  if (!file || std::filesystem::equivalent(*file, other, error)) return;  // another name of it
  if (readText(*file) != readText(other)) {
    differences_.add(name + ": it is not the same as '" + other.string() + "'");
  }
}

std::vector<std::string> FoundFiles::problems() const {
  std::vector<std::string> problems = differences_.lines();
  for (const std::string& name : left_) {
    problems.push_back("found the file '" + name + "', which the format does not have");
    if (problems.size() > 10) break;  // more of the same
  }
  return problems;
}

}  // namespace synthetic_dataset::formats
