#pragma once

#include <chrono>

namespace synthetic_dataset::run {

/// How long a run worked [s], by stage. Drawing, labels and writing run concurrently, in a thread
/// each, so that their sum exceeds the duration of the run.
struct StageTimes {
  double setup = 0.0;          ///< reading and checking all inputs
  double drawing = 0.0;        ///< moving the world and drawing it
  double labels = 0.0;         ///< finishing pictures and measuring labels
  double writing = 0.0;        ///< formatting, encoding and writing scenes
  double dataset_files = 0.0;  ///< writing the files that describe the whole dataset
};

/// Measures time. No file depends on it.
class StageWatch {
 public:
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace synthetic_dataset::run
