#include "programs/console/ticker.h"

#include <chrono>
#include <utility>

namespace synthetic_dataset::programs {

Ticker::Ticker(std::function<void()> tick)
    : thread_([this, tick = std::move(tick)] { run(tick); }) {}

Ticker::~Ticker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void Ticker::run(const std::function<void()>& tick) {
  constexpr auto kPeriod = std::chrono::milliseconds(200);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!changed_.wait_for(lock, kPeriod, [this] { return is_over_; })) tick();
}

}  // namespace synthetic_dataset::programs
