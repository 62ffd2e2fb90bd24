#include "scene/camera_pictures.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include <opencv2/core.hpp>

#include "base/image/picture_decoder.h"
#include "base/image/raw_picture.h"
#include "motion/bag/ros_time.h"
#include "motion/timeline.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {
namespace {

using motion::PictureHead;

/// The picture whose stamp is nearest to a time in its own clock.
std::size_t nearestTo(Stamp stamp, const std::vector<PictureHead>& heads) {
  const auto after =
      std::lower_bound(heads.begin(), heads.end(), stamp,
                       [](const PictureHead& head, Stamp wanted) { return head.stamp < wanted; });
  if (after == heads.begin()) return 0;
  const auto before = std::prev(after);
  const bool is_before = after == heads.end() || stamp - before->stamp <= after->stamp - stamp;
  return static_cast<std::size_t>((is_before ? before : after) - heads.begin());
}

Duration distanceOf(Stamp a, Stamp b) { return a < b ? b - a : a - b; }

/// Old publishers swapped red and blue: "rgb8; jpeg compressed rgb8" (see
/// compressed_image_transport's subscriber).
bool hasSwappedChannels(const std::string& format) {
  return format.find("compressed rgb") != std::string::npos;
}

bool isJpegFile(const std::vector<std::uint8_t>& bytes) {
  return bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8 && bytes[2] == 0xFF;
}

TakenPicture developed(motion::RecordedPicture picture, const std::string& topic) {
  if (const auto* raw = std::get_if<base::RawPicture>(&picture)) {
    return {base::coloursOf(*raw), {}};
  }
  auto& file = std::get<motion::PictureFile>(picture);
  cv::Mat colours = base::coloursOf(base::decodePixels(file.bytes, topic));
  if (hasSwappedChannels(file.format)) {
    cv::Mat swapped(colours.size(), colours.type());
    const std::vector<int> pairs = {0, 2, 1, 1, 2, 0};
    cv::mixChannels({colours}, {swapped}, pairs);
    return {swapped, {}};
  }
  const bool is_jpeg = isJpegFile(file.bytes);
  return {colours, is_jpeg ? std::move(file.bytes) : std::vector<std::uint8_t>()};
}

}  // namespace

CameraPictures::CameraPictures(const std::vector<CameraOptions>& cameras,
                               const RecordedImageOptions& twin,
                               const std::vector<std::string>& bag_files,
                               base::Diagnostics& diagnostics) {
  std::vector<std::string> errors;
  for (const CameraOptions& camera : cameras) {
    const std::string setting = camera.group + "/image_topic";
    try {
      pictures_.emplace_back(bag_files, *camera.image_topic);
    } catch (const Error& error) {
      errors.push_back(setting + ": " + error.what());
      continue;
    }
    groups_.push_back(camera.group);
    offsets_.push_back(camera.time_offset);
    const std::int64_t repeated = pictures_.back().repeatedCount();
    if (repeated > 0) {
      diagnostics.warning(setting, "pictures with the same stamp as another are left out",
                          repeated);
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
  const std::vector<PictureHead>& first = pictures_.front().heads();
  for (std::size_t i = 0; i < first.size(); i += static_cast<std::size_t>(twin.every)) {
    at_[first[i].stamp + offsets_.front()] = {i};
  }
  for (std::size_t i = 1; i < cameras.size(); ++i) {
    addPicturesOf(i, cameras[i], twin.same_time, diagnostics);
  }
}

/// Adds the pictures that match the first camera's in time; times without one are left out.
void CameraPictures::addPicturesOf(std::size_t camera, const CameraOptions& options,
                                   Duration same_time, base::Diagnostics& diagnostics) {
  const std::vector<PictureHead>& heads = pictures_[camera].heads();
  std::vector<Duration> distances;
  std::map<Stamp, std::vector<std::size_t>> kept;
  for (auto& [time, pictures] : at_) {
    const Stamp wanted = time - offsets_[camera];
    const std::size_t nearest = nearestTo(wanted, heads);
    distances.push_back(distanceOf(heads[nearest].stamp, wanted));
    if (distances.back() > same_time) continue;
    pictures.push_back(nearest);
    kept.emplace(time, std::move(pictures));
  }
  const std::string setting = options.group + "/image_topic";
  const std::string within = fixed(1e3 * toSeconds(same_time), 3) + " ms (twin/same_time)";
  if (kept.empty()) {
    std::sort(distances.begin(), distances.end());
    throw ErrorList({setting + ": none of its pictures is within " + within + " of one of " +
                     groups_.front() + "; the nearest are " +
                     fixed(1e3 * toSeconds(distances[distances.size() / 2]), 3) +
                     " ms away (median). Cameras whose shutters do not open together should be "
                     "labelled one by one: in a run each, or in a motion each (motions)"});
  }
  const auto lost = static_cast<std::int64_t>(at_.size() - kept.size());
  if (lost > 0) {
    diagnostics.warning(
        setting,
        "scene left out: there is no picture within " + within + " of that of " + groups_.front(),
        lost);
  }
  at_ = std::move(kept);
}

const std::string& CameraPictures::frame(std::size_t camera) const {
  return pictures_[camera].heads().front().frame;
}

std::vector<Stamp> CameraPictures::stamps() const {
  std::vector<Stamp> stamps;
  for (const auto& [time, pictures] : at_) stamps.push_back(time);
  return stamps;
}

std::optional<double> CameraPictures::rate() const { return motion::usualRate(stamps()); }

std::string CameraPictures::problemOf(std::size_t camera, std::size_t picture,
                                      const CameraRig& rig) const {
  const PictureHead& head = pictures_[camera].heads()[picture];
  if (!head.problem.empty()) return head.problem;
  const auto width = static_cast<std::uint32_t>(rig.model.width());
  const auto height = static_cast<std::uint32_t>(rig.model.height());
  if (head.width == width && head.height == height) return "";
  return "has " + std::to_string(head.width) + " x " + std::to_string(head.height) +
         " pixels; its calibration is of " + std::to_string(width) + " x " +
         std::to_string(height) + ", and should be that of the picture";
}

std::vector<std::string> CameraPictures::problems(const std::vector<Stamp>& times,
                                                  const std::vector<CameraRig>& rigs) const {
  std::vector<std::string> messages;
  for (std::size_t camera = 0; camera < pictures_.size(); ++camera) {
    std::map<std::string, std::vector<Stamp>> stamps;  // by the problem
    for (const Stamp time : times) {
      const std::size_t picture = at_.at(time)[camera];
      const std::string problem = problemOf(camera, picture, rigs[camera]);
      if (!problem.empty()) {
        stamps[problem].push_back(pictures_[camera].heads()[picture].stamp);
      }
    }
    for (const auto& [problem, of_these] : stamps) {
      const std::size_t others = of_these.size() - 1;
      messages.push_back(
          groups_[camera] + "/image_topic: " +
          motion::pictureName(pictures_[camera].topic(), of_these.front()) + " " + problem +
          (others == 0 ? "" : "; the same holds for " + std::to_string(others) + " more"));
    }
  }
  return messages;
}

void CameraPictures::shift(Duration later) {
  std::map<Stamp, std::vector<std::size_t>> shifted;
  for (auto& [time, pictures] : at_) shifted.emplace(time + later, std::move(pictures));
  at_ = std::move(shifted);
  for (Duration& offset : offsets_) offset += later;
}

TakenPicture CameraPictures::take(std::size_t camera, Stamp time) const {
  const std::size_t picture = std::prev(at_.upper_bound(time))->second.at(camera);
  const motion::RecordedPictures& pictures = pictures_[camera];
  try {
    return developed(pictures.read(picture), pictures.topic());
  } catch (const Error& error) {
    throw Error(groups_[camera] + "/image_topic: " +
                motion::pictureName(pictures.topic(), pictures.heads()[picture].stamp) + " " +
                error.what());
  }
}

}  // namespace synthetic_dataset::scene
