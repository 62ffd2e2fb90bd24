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

/// A recorded picture of a scene.
struct TakenPicture {
  cv::Mat pixels;                  ///< CV_8UC3: blue, green, red
  std::vector<std::uint8_t> jpeg;  ///< the file that they were decoded from, if it is a JPEG
};

/// The recorded pictures of a motion's cameras: their times and their contents.
class CameraPictures {
 public:
  /// @param cameras  all with an image_topic
  /// @param diagnostics  receives what the user should know: pictures for which another camera has
  ///     none, ...
  /// @throws ErrorList naming the settings, if a topic cannot be read or the cameras have no
  ///     pictures at the same time
  CameraPictures(const std::vector<CameraOptions>& cameras, const RecordedImageOptions& twin,
                 const std::vector<std::string>& bag_files, base::Diagnostics& diagnostics);

  /// The frame in the headers of a camera's pictures; empty if there is none.
  [[nodiscard]] const std::string& frame(std::size_t camera) const;

  /// What is added to stamps of the first camera's clock to give TF's.
  [[nodiscard]] Duration timeOffset() const { return offsets_.front(); }

  /// The times of scenes, ascending: the first camera's stamps plus its time_offset. At least one.
  [[nodiscard]] std::vector<Stamp> stamps() const;

  /// Scenes per second, from the median time between consecutive ones; nothing for a single scene.
  [[nodiscard]] std::optional<double> rate() const;

  /// What prevents scenes at these times: each kind of problem once, naming the first picture that
  /// has it. "camera/image_topic: the picture of '/image' at 12 s has ..."
  [[nodiscard]] std::vector<std::string> problems(const std::vector<Stamp>& times,
                                                  const std::vector<CameraRig>& rigs) const;

  /// Shifts all times later, or earlier if negative, as if the cameras' time offsets were larger by
  /// `later`.
  void shift(Duration later);

  /// Reads the picture of a scene. May be called in any thread.
  /// @param time  one of stamps(); between two of them, the picture of the earlier one is read
  /// @throws Error naming the topic and the stamp, if it cannot be decoded
  [[nodiscard]] TakenPicture take(std::size_t camera, Stamp time) const;

 private:
  [[nodiscard]] std::string problemOf(std::size_t camera, std::size_t picture,
                                      const CameraRig& rig) const;
  void addPicturesOf(std::size_t camera, const CameraOptions& options, Duration same_time,
                     base::Diagnostics& diagnostics);

  std::vector<std::string> groups_;                 ///< of the cameras, for messages
  std::vector<motion::RecordedPictures> pictures_;  ///< of the cameras
  std::vector<Duration> offsets_;                   ///< of the cameras' clocks
  std::map<Stamp, std::vector<std::size_t>> at_;    ///< index of each camera's picture, by time
};

}  // namespace synthetic_dataset::scene
