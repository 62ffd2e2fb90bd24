#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "base/diagnostics.h"
#include "motion/recorded/recorded_pictures.h"
#include "scene/camera_options.h"
#include "scene/camera_rig.h"
#include "scene/recorded_image_options.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::scene {

/// A recorded picture as a scene has it.
struct TakenPicture {
  cv::Mat pixels;                  ///< CV_8UC3: blue, green, red
  std::vector<std::uint8_t> jpeg;  ///< the file that they were decoded from, if it is a JPEG
};

/// The recorded pictures of a motion's cameras: at which times there are some, and what they show.
class CameraPictures {
 public:
  /// @param cameras  all with an image_topic
  /// @param diagnostics  what the user should know: pictures without one of the other cameras, ...
  /// @throws ErrorList naming the settings, when a topic cannot be read or the cameras have no
  ///     picture at the same time
  CameraPictures(const std::vector<CameraOptions>& cameras, const RecordedImageOptions& twin,
                 const std::vector<std::string>& bag_files, base::Diagnostics& diagnostics);

  /// The frame that the headers of a camera's pictures have; empty: none.
  [[nodiscard]] const std::string& frame(std::size_t camera) const;

  /// What is added to the stamps of the first camera's clock for that of TF.
  [[nodiscard]] Duration timeOffset() const { return offsets_.front(); }

  /// When there are scenes, ascending: the first camera's stamps and its time_offset. At least one.
  [[nodiscard]] std::vector<Stamp> stamps() const;

  /// Scenes a second, by the median of the time from one to the next; nothing for a single one.
  [[nodiscard]] std::optional<double> rate() const;

  /// What prevents scenes at these times: each kind of problem once, with the first picture that
  /// has it. "camera/image_topic: the picture of '/image' at 12 s has ..."
  [[nodiscard]] std::vector<std::string> problems(const std::vector<Stamp>& times,
                                                  const std::vector<CameraRig>& rigs) const;

  /// Lets all times be later, or earlier if negative, as if the cameras' time offsets were so much
  /// larger.
  void shift(Duration later);

  /// The picture of a scene, in any thread.
  /// @param time  one of stamps(); of one between two, the picture is that of the earlier
  /// @throws Error naming topic and stamp where it cannot be decoded
  [[nodiscard]] TakenPicture take(std::size_t camera, Stamp time) const;

 private:
  [[nodiscard]] std::string problemOf(std::size_t camera, std::size_t picture,
                                      const CameraRig& rig) const;
  void addPicturesOf(std::size_t camera, const CameraOptions& options, Duration same_time,
                     base::Diagnostics& diagnostics);

  std::vector<std::string> groups_;                 ///< of the cameras, for messages
  std::vector<motion::RecordedPictures> pictures_;  ///< of the cameras
  std::vector<Duration> offsets_;                   ///< of the cameras' clocks
  std::map<Stamp, std::vector<std::size_t>> at_;    ///< each camera's picture, by time
};

}  // namespace synthetic_dataset::scene
