#include "programs/drawing/video_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <system_error>
#include <utility>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

extern char** environ;

namespace synthetic_dataset::programs {

namespace {

std::string lastError() { return std::generic_category().message(errno); }

std::vector<std::string> commandFor(const std::string& file, double rate, const cv::Size& size) {
  return {"ffmpeg", "-nostdin", "-loglevel", "error", "-y", "-f", "rawvideo", "-pixel_format",
          "bgr24", "-video_size", std::to_string(size.width) + "x" + std::to_string(size.height),
          "-framerate", fixed(rate, 3), "-i", "pipe:0",
          // What browsers play: even sizes, one colour per four pixels, the index at the beginning.
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", "-crf", "20", "-movflags",
          "+faststart",
          // Without the prefix, a name that begins with a dash would be taken as an option.
          "file:" + file};
}

/// The picture, scaled to fit and centred in one of this size.
cv::Mat fitted(const cv::Mat& picture, const cv::Size& size) {
  const double scale = std::min(static_cast<double>(size.width) / picture.cols,
                                static_cast<double>(size.height) / picture.rows);
  const cv::Size inner(
      std::clamp(static_cast<int>(std::lround(picture.cols * scale)), 1, size.width),
      std::clamp(static_cast<int>(std::lround(picture.rows * scale)), 1, size.height));
  cv::Mat frame(size, CV_8UC3, cv::Scalar::all(30));
  cv::resize(
      picture,
      frame(cv::Rect({(size.width - inner.width) / 2, (size.height - inner.height) / 2}, inner)),
      inner, 0, 0, cv::INTER_AREA);
  return frame;
}

}  // namespace

VideoFile::VideoFile(std::string file, double rate) : file_(std::move(file)), rate_(rate) {}

VideoFile::~VideoFile() {
  closeInput();
  if (process_ < 0) return;
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

void VideoFile::start() {
  // A socket instead of a pipe: writing to a program that has ended then fails with an error, not
  // a signal.
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw Error("cannot start ffmpeg: " + lastError());
  }
  input_ = ends[1];
  const std::vector<std::string> command = commandFor(file_, rate_, size_);
  std::vector<char*> arguments;
  for (const std::string& each : command) arguments.push_back(const_cast<char*>(each.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  const int failure =
      ::posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  if (failure == 0) return;
  process_ = -1;
  throw Error("cannot start ffmpeg: " + std::generic_category().message(failure) +
              "; `sudo apt-get install ffmpeg` installs it");
}

void VideoFile::add(const cv::Mat& picture) {
  if (process_ < 0) {
    size_ = picture.size();
    start();
  }
  write(picture.size() == size_ ? picture : fitted(picture, size_));
}

void VideoFile::write(const cv::Mat& picture) const {
  const cv::Mat whole = picture.isContinuous() ? picture : picture.clone();
  const std::size_t size = whole.total() * whole.elemSize();
  for (std::size_t done = 0; done < size;) {
    const ssize_t count = ::send(input_, whole.data + done, size - done, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw Error("'" + file_ + "': ffmpeg has ended before the last picture");
    done += static_cast<std::size_t>(count);
  }
}

void VideoFile::finish() {
  if (process_ < 0) throw Error("'" + file_ + "': there are no pictures to make a video of");
  closeInput();
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Error("'" + file_ + "': ffmpeg has failed; its message is above");
  }
}

void VideoFile::closeInput() {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
}

}  // namespace synthetic_dataset::programs
