#include "programs/console/start_report.h"

#include <utility>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr double kPatience = 2.0;  ///< [s] for which nobody wonders

}  // namespace

StartReport::StartReport(Clock clock, Sink sink)
    : clock_(std::move(clock)),
      sink_(std::move(sink)),
      start_(clock_()),
      next_(start_ + kPatience) {}

void StartReport::begin(const std::string& stage) {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = stage;
}

void StartReport::look() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const double now = clock_();
  if (now < next_ || stage_.empty() || !reported_.insert(stage_).second) return;
  next_ = now + kPatience;
  sink_("still starting after " + fixed(now - start_, 0) + " s: " + stage_);
}

}  // namespace synthetic_dataset::programs
