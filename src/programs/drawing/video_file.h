#pragma once

#include <sys/types.h>

#include <string>

#include <opencv2/core.hpp>

namespace synthetic_dataset::programs {

/// A video that ffmpeg, in a process of its own, encodes from pictures.
class VideoFile {
 public:
  /// @param file  ends in .mp4
  /// @param rate  pictures per second [Hz]
  VideoFile(std::string file, double rate);
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Stops ffmpeg if `finish` was not called.
  ~VideoFile();

  /// @param picture  8 bit BGR; fitted into the first picture's size if its own differs
  /// @throws Error when ffmpeg is not installed or has ended
  void add(const cv::Mat& picture);

  /// Waits until the video is complete. @throws Error when ffmpeg fails or there was no picture
  void finish();

 private:
  void start();
  void write(const cv::Mat& picture) const;
  void closeInput();

  std::string file_;
  double rate_ = 0.0;
  cv::Size size_;
  pid_t process_ = -1;
  int input_ = -1;  ///< ffmpeg's standard input
};

}  // namespace synthetic_dataset::programs
