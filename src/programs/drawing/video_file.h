#pragma once

#include <sys/types.h>

#include <string>

#include <opencv2/core.hpp>

namespace synthetic_dataset::programs {

/// A film that ffmpeg, a program of its own, makes of pictures.
class VideoFile {
 public:
  /// @param file  ends in .mp4
  /// @param rate  pictures a second [Hz]
  VideoFile(std::string file, double rate);
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// Stops ffmpeg where `finish` was not called.
  ~VideoFile();

  /// @param picture  8 bit BGR; one of another size than the first is fitted into that
  /// @throws Error when ffmpeg is not there or ends
  void add(const cv::Mat& picture);

  /// Waits until the film is whole. @throws Error when it is not, or has no picture
  void finish();

 private:
  void start();
  void write(const cv::Mat& picture) const;
  void closeInput();

  std::string file_;
  double rate_ = 0.0;
  cv::Size size_;
  pid_t process_ = -1;
  int input_ = -1;  ///< of ffmpeg
};

}  // namespace synthetic_dataset::programs
