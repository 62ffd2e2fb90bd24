#include "programs/preview/preview_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::chrono::milliseconds kAskWhetherEnded{100};

std::chrono::steady_clock::duration periodOf(double rate) {
  constexpr double kSlowest = 1e-3;  // [Hz]
  if (!(rate >= kSlowest) || !std::isfinite(rate)) {
    throw Error("found a rate of " + fixed(rate, 3) + " Hz; it should be at least 0.001 Hz");
  }
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(1.0 / rate));
}

}  // namespace

PreviewControl::PreviewControl(std::function<bool()> is_ended, double rate)
    : is_ended_(std::move(is_ended)), order_(Order{0, true}), period_(periodOf(rate)) {}

void PreviewControl::order(std::int64_t instant, bool reads_settings) {
  // A pending order to read the settings is not lost.
  const bool was_to_read = order_ && order_->reads_settings;
  order_ = Order{std::max<std::int64_t>(instant, 0), reads_settings || was_to_read};
  changed_.notify_all();
}

void PreviewControl::step() {
  const Lock lock(mutex_);
  is_playing_ = false;
  ++turns_;
  changed_.notify_all();
}

void PreviewControl::stepBack() {
  const Lock lock(mutex_);
  is_playing_ = false;
  order(instant_ - 1, false);
}

void PreviewControl::play() {
  const Lock lock(mutex_);
  if (!is_playing_) next_ = Clock::now() + period_;
  is_playing_ = true;
  // After the last instant comes the first one.
  if (!is_making_ && !order_) order(0, false);
  changed_.notify_all();
}

void PreviewControl::pause() {
  const Lock lock(mutex_);
  is_playing_ = false;
  turns_ = 0;
  changed_.notify_all();
}

void PreviewControl::jumpTo(std::int64_t instant) {
  const Lock lock(mutex_);
  order(instant, false);
}

void PreviewControl::reload() {
  const Lock lock(mutex_);
  order(instant_, true);
}

void PreviewControl::makeAgain() {
  const Lock lock(mutex_);
  if (!order_) order(instant_, false);
}

void PreviewControl::setRate(double rate) {
  const Clock::duration period = periodOf(rate);
  const Lock lock(mutex_);
  period_ = period;
  next_ = std::min(next_, Clock::now() + period);
  changed_.notify_all();
}

PreviewControl::State PreviewControl::state() const {
  const Lock lock(mutex_);
  if (order_ || (is_making_ && !has_shown_)) return State::kLoading;
  return is_playing_ ? State::kPlaying : State::kPaused;
}

std::optional<PreviewControl::Order> PreviewControl::awaitOrder() {
  Lock lock(mutex_);
  // A run that was played to its end stays there.
  is_making_ = false;
  if (!order_) is_playing_ = false;
  while (!order_ && !is_ended_()) waitForChange(lock, std::nullopt);
  if (is_ended_()) return std::nullopt;
  turns_ = 1;
  is_making_ = true;
  has_shown_ = false;
  instant_ = order_->instant;
  return std::exchange(order_, std::nullopt);
}

bool PreviewControl::isInterruptedHere() const { return order_ || is_ended_(); }

bool PreviewControl::isInterrupted() const {
  const Lock lock(mutex_);
  return isInterruptedHere();
}

bool PreviewControl::awaitTurn(std::int64_t instant) {
  Lock lock(mutex_);
  while (!isInterruptedHere()) {
    if (has_shown_ && instant == instant_) return true;  // another camera's scene of the instant
    const bool is_time = is_playing_ && Clock::now() >= next_;
    if (turns_ > 0 || is_time) {
      turns_ = std::max<std::int64_t>(turns_ - 1, 0);
      instant_ = instant;
      has_shown_ = true;
      next_ = Clock::now() + period_;
      return true;
    }
    waitForChange(lock, is_playing_ ? std::optional(next_) : std::nullopt);
  }
  return false;
}

void PreviewControl::waitForChange(Lock& lock, std::optional<Clock::time_point> until) {
  const Clock::time_point asks = Clock::now() + kAskWhetherEnded;
  changed_.wait_until(lock, until ? std::min(*until, asks) : asks);
}

}  // namespace synthetic_dataset::programs
