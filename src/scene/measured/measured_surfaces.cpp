#include "scene/measured/measured_surfaces.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/diagnostics.h"
#include "motion/bag/ros_time.h"
#include "motion/recorded/recorded_camera_info.h"
#include "motion/recorded/recorded_clouds.h"
#include "motion/recorded/recorded_depths.h"
#include "scene/calibration/camera_info.h"
#include "scene/camera_poses.h"
#include "scene/measured/range_image.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::scene {
namespace {

constexpr const char* kDepthSetting = "twin/depth_topic: ";
constexpr const char* kCloudSetting = "twin/cloud_topic: ";
constexpr const char* kInfoSetting = "twin/depth_info_topic: ";

/// When measurements were made, in TF's clock, and in which frames.
struct Measurements {
  std::vector<Stamp> times;  ///< ascending
  std::vector<std::string> frames;
  Duration longest{0};  ///< largest allowed distance from a scene

  /// The measurement nearest to a time, however far away; there is at least one.
  [[nodiscard]] std::size_t nearestTo(Stamp time) const {
    const auto after = std::lower_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return 0;
    const bool is_before = after == times.end() || time - *std::prev(after) <= *after - time;
    return static_cast<std::size_t>((is_before ? std::prev(after) : after) - times.begin());
  }

  [[nodiscard]] Duration distanceTo(Stamp time) const {
    const Stamp nearest = times[nearestTo(time)];
    return nearest < time ? time - nearest : nearest - time;
  }

  [[nodiscard]] std::optional<std::size_t> at(Stamp time) const {
    if (distanceTo(time) > longest) return std::nullopt;
    return nearestTo(time);
  }
};

template <class Head>
Measurements measurementsOf(const std::vector<Head>& heads, Duration clock, Duration longest) {
  Measurements all;
  all.longest = longest;
  for (const Head& head : heads) {
    all.times.push_back(head.stamp + clock);
    all.frames.push_back(head.frame);
  }
  return all;
}

/// Each kind of problem once, naming the first message that has it.
template <class Head>
std::vector<std::string> problemsOf(const std::vector<Head>& heads, const std::string& setting,
                                    const std::string& named) {
  std::map<std::string, std::vector<Stamp>> stamps;  // by the problem
  for (const Head& head : heads) {
    if (!head.problem.empty()) stamps[head.problem].push_back(head.stamp);
  }
  std::vector<std::string> messages;
  for (const auto& [problem, of_these] : stamps) {
    const std::size_t others = of_these.size() - 1;
    messages.push_back(
        setting + named + " at " + motion::secondsText(of_these.front()) + " " + problem +
        (others == 0 ? "" : "; the same holds for " + std::to_string(others) + " more"));
  }
  return messages;
}

std::string sizeText(std::uint32_t width, std::uint32_t height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

/// "/camera/depth/camera_info" of "/camera/depth/image_raw/compressedDepth", as in image_transport.
std::string infoTopicOf(std::string topic) {
  const std::string transport = "/compressedDepth";
  if (topic.size() > transport.size() &&
      topic.compare(topic.size() - transport.size(), transport.size(), transport) == 0) {
    topic.resize(topic.size() - transport.size());
  }
  return topic.substr(0, topic.rfind('/') + 1) + "camera_info";
}

}  // namespace

struct MeasuredSurfaces::Impl {
  /// The depth camera as used for one of the pictures' cameras.
  struct DepthView {
    std::shared_ptr<const DepthLens> lens;
    Pose X_FD = Pose::Identity();  ///< of the depth image in its header's frame
  };

  Impl(const std::vector<CameraRig>& rigs, const CameraPictures& pictures,
       const motion::FrameSource& source)
      : cameras(rigs), frames(source) {
    for (std::size_t i = 0; i < rigs.size(); ++i) picture_frames.push_back(pictures.frame(i));
  }

  void readDepths(const RecordedImageOptions& twin, const std::vector<std::string>& bag_files,
                  Duration clock) {
    try {
      depths.emplace(bag_files, *twin.depth_topic);
    } catch (const Error& error) {
      throw Error(kDepthSetting + std::string(error.what()));
    }
    const std::vector<motion::PictureHead>& heads = depths->heads();
    const std::string named = "the depth image of '" + *twin.depth_topic + "'";
    const std::vector<std::string> problems = problemsOf(heads, kDepthSetting, named);
    if (!problems.empty()) throw ErrorList(problems);
    depth_times = measurementsOf(heads, clock, twin.depth_time);
    findDepthViews(twin, bag_files);
    checkSizes(named);
    checkFrames(depth_times, kDepthSetting, named);
  }

  void readClouds(const RecordedImageOptions& twin, const std::vector<std::string>& bag_files) {
    try {
      clouds.emplace(bag_files, *twin.cloud_topic);
    } catch (const Error& error) {
      throw Error(kCloudSetting + std::string(error.what()));
    }
    const std::string named = "the cloud of '" + *twin.cloud_topic + "'";
    const std::vector<std::string> problems = problemsOf(clouds->heads(), kCloudSetting, named);
    if (!problems.empty()) throw ErrorList(problems);
    cloud_times = measurementsOf(clouds->heads(), Duration{0}, twin.depth_time);
    checkFrames(cloud_times, kCloudSetting, named);
  }

  /// Uses the depth camera's own calibration, or else that of the pictures' camera, if it is the
  /// same camera.
  void findDepthViews(const RecordedImageOptions& twin, const std::vector<std::string>& bag_files) {
    const std::string topic = twin.depth_info_topic.value_or(infoTopicOf(*twin.depth_topic));
    std::optional<motion::RecordedCameraInfo> info;
    std::string missing;
    try {
      info = motion::readCameraInfo(bag_files, topic);
    } catch (const Error& error) {
      missing = error.what();
    }
    if (info) {
      const CalibratedCamera camera =
          cameraOf(info->info, kInfoSetting + topic, {twin.depth_is_rectified});
      const DepthView view{std::make_shared<DepthLens>(camera.model), camera.X_FC};
      views.assign(cameras.size(), view);
      for (std::string& frame : depth_times.frames) {
        if (frame.empty()) frame = info->frame;
      }
      return;
    }
    if (twin.depth_info_topic) throw Error(kInfoSetting + missing);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      if (!isFrameOf(i, depth_times.frames.front())) {
        throw Error("twin/depth_info_topic: missing, and the depth images of '" +
                    *twin.depth_topic + "' have the frame '" + depth_times.frames.front() +
                    "', which is not that of the pictures' camera ('" + frameOf(i) +
                    "'); it should name their CameraInfo. Looked for '" + topic + "': " + missing);
      }
      views.push_back({std::make_shared<DepthLens>(cameras[i].model), cameras[i].X_FC});
    }
  }

  void checkSizes(const std::string& named) const {
    const CameraModel& model = views.front().lens->camera();
    const auto width = static_cast<std::uint32_t>(model.width());
    const auto height = static_cast<std::uint32_t>(model.height());
    for (const motion::PictureHead& head : depths->heads()) {
      if (head.width == width && head.height == height) continue;
      throw Error(kDepthSetting + named + " at " + motion::secondsText(head.stamp) + " has " +
                  sizeText(head.width, head.height) + " pixels; its calibration is of " +
                  sizeText(width, height) +
                  ". twin/depth_info_topic should name the CameraInfo of the depth images");
    }
  }

  /// Whether a frame is that of a picture's camera, judging by the names.
  [[nodiscard]] bool isFrameOf(std::size_t camera, const std::string& frame) const {
    return frame.empty() || frame == cameras[camera].frame || frame == picture_frames[camera];
  }

  [[nodiscard]] std::string frameOf(std::size_t camera) const {
    return picture_frames[camera].empty() ? cameras[camera].frame : picture_frames[camera];
  }

  void checkFrames(const Measurements& all, const std::string& setting,
                   const std::string& named) const {
    for (const std::string& frame : std::set<std::string>(all.frames.begin(), all.frames.end())) {
      bool is_of_all = true;
      for (std::size_t i = 0; i < cameras.size(); ++i) is_of_all &= isFrameOf(i, frame);
      if (is_of_all || frames.find(frame)) continue;
      throw Error(setting + named + " is in the frame '" + frame + "'; " + frames.lacks(frame));
    }
  }

  /// X_GF at the time of a measurement in a frame; nothing if it is not known.
  [[nodiscard]] std::optional<Pose> poseOf(const std::string& frame, Stamp measured,
                                           std::size_t camera, const world::World& world,
                                           Stamp time) const {
    const CameraRig& rig = cameras[camera];
    if (isFrameOf(camera, frame)) return cameraPose(rig, world, frames, time, measured - time).X_GF;
    const auto found = frames.find(frame);
    return found ? frames.pose(*found, measured) : std::nullopt;
  }

  [[nodiscard]] PendingRanges depthsFor(std::size_t camera, const world::World& world, Stamp time,
                                        const Pose& X_GC) const {
    const auto index = depths ? depth_times.at(time) : std::nullopt;
    if (!index) return [] { return cv::Mat(); };
    const auto X_GF =
        poseOf(depth_times.frames[*index], depth_times.times[*index], camera, world, time);
    if (!X_GF) return [] { return cv::Mat(); };
    const DepthView& view = views[camera];
    return [this, index = *index, camera, lens = view.lens,
            X_CD = Pose(X_GC.inverse() * *X_GF * view.X_FD)] {
      const cv::Mat depth =
          base::namingPlace(depthName(index), [&] { return depths->read(index); });
      return rangesOfDepth(depth, *lens, X_CD, cameras[camera].model);
    };
  }

  [[nodiscard]] PendingRanges cloudsFor(std::size_t camera, const world::World& world, Stamp time,
                                        const Pose& X_GC) const {
    const auto index = clouds ? cloud_times.at(time) : std::nullopt;
    if (!index) return [] { return cv::Mat(); };
    const auto X_GF =
        poseOf(cloud_times.frames[*index], cloud_times.times[*index], camera, world, time);
    if (!X_GF) return [] { return cv::Mat(); };
    return [this, index = *index, camera, X_CF = Pose(X_GC.inverse() * *X_GF)] {
      std::vector<Eigen::Vector3d> points = clouds->read(index);
      for (Eigen::Vector3d& point : points) point = X_CF * point;
      return rangesOfCloud(points, cameras[camera].model);
    };
  }

  std::vector<CameraRig> cameras;
  /// For messages.
  [[nodiscard]] std::string depthName(std::size_t index) const {
    return "twin/depth_topic: the depth image at " +
           motion::secondsText(depths->heads()[index].stamp);
  }

  const motion::FrameSource& frames;
  std::vector<std::string> picture_frames;  ///< of the cameras, from the headers
  std::optional<motion::RecordedDepths> depths;
  Measurements depth_times;
  std::vector<DepthView> views;  ///< of the cameras
  std::optional<motion::RecordedClouds> clouds;
  Measurements cloud_times;
};

MeasuredSurfaces::MeasuredSurfaces(const RecordedImageOptions& twin,
                                   const std::vector<std::string>& bag_files,
                                   const std::vector<CameraRig>& cameras,
                                   const CameraPictures& pictures,
                                   const motion::FrameSource& frames)
    : impl_(std::make_unique<Impl>(cameras, pictures, frames)) {
  base::Diagnostics errors;
  if (twin.depth_topic) {
    (void)errors.attempt([&] { impl_->readDepths(twin, bag_files, pictures.timeOffset()); });
  }
  if (twin.cloud_topic) (void)errors.attempt([&] { impl_->readClouds(twin, bag_files); });
  errors.throwIfAny();
}

MeasuredSurfaces::~MeasuredSurfaces() = default;

void MeasuredSurfaces::check(const std::vector<Stamp>& times,
                             base::Diagnostics& diagnostics) const {
  const auto checkOne = [&](const Measurements& all, const std::string& setting,
                            const std::string& noun) {
    std::vector<Duration> distances;
    for (const Stamp time : times) distances.push_back(all.distanceTo(time));
    std::sort(distances.begin(), distances.end());
    const auto lost = std::distance(
        std::upper_bound(distances.begin(), distances.end(), all.longest), distances.end());
    if (lost == 0) return;
    const std::string within =
        " within " + fixed(1e3 * toSeconds(all.longest), 0) + " ms (twin/depth_time)";
    if (static_cast<std::size_t>(lost) == times.size()) {
      diagnostics.error(setting, "no " + noun + " is" + within + " of a picture; the nearest are " +
                                     fixed(1e3 * toSeconds(distances[distances.size() / 2]), 0) +
                                     " ms away (median)");
    } else {
      diagnostics.warning(setting,
                          "scene without a " + noun + within + ": nothing hides its objects", lost);
    }
  };
  if (impl_->depths) checkOne(impl_->depth_times, "twin/depth_topic", "depth image");
  if (impl_->clouds) checkOne(impl_->cloud_times, "twin/cloud_topic", "cloud");
}

PendingRanges MeasuredSurfaces::seenBy(std::size_t camera, const world::World& world, Stamp time,
                                       const Pose& X_GC) const {
  return [depths = impl_->depthsFor(camera, world, time, X_GC),
          clouds = impl_->cloudsFor(camera, world, time, X_GC)] {
    return nearestOf(depths(), clouds());
  };
}

}  // namespace synthetic_dataset::scene
