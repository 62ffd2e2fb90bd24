#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

namespace synthetic_dataset::programs {

/// Controls which instant of a run is shown, and when the next one follows.
///
/// Users give commands from any thread. The thread that makes scenes asks for orders, and makes the
/// scenes from an order's instant on until it is interrupted; the thread that shows them waits for
/// each instant's turn.
class PreviewControl {
 public:
  /// What to make: the run's scenes from an instant on.
  struct Order {
    std::int64_t instant = 0;
    bool reads_settings = false;  ///< whether to read the settings again first
  };

  enum class State { kLoading, kPaused, kPlaying };

  /// @param is_ended  called now and then while a thread waits: whether the program is to end
  /// @param rate  instants per second while it plays [Hz], at least 0.001
  PreviewControl(std::function<bool()> is_ended, double rate);

  void step();
  void stepBack();
  void play();
  void pause();
  void jumpTo(std::int64_t instant);
  void reload();

  /// Orders the instant that is shown again, to make what was not made of it before.
  void makeAgain();

  /// @throws Error unless it is finite and at least 0.001 Hz
  void setRate(double rate);

  [[nodiscard]] State state() const;

  // For the thread that makes scenes:

  /// Waits until there is something to make. Returns nothing when the program ends.
  [[nodiscard]] std::optional<Order> awaitOrder();

  /// Whether there is another order, or the program ends.
  [[nodiscard]] bool isInterrupted() const;

  // For the thread that shows them:

  /// Waits until it is time to show an instant, the next one of the current order.
  /// @return false when it is not to be shown, as there is another order or the program ends
  [[nodiscard]] bool awaitTurn(std::int64_t instant);

 private:
  using Lock = std::unique_lock<std::mutex>;
  using Clock = std::chrono::steady_clock;

  void order(std::int64_t instant, bool reads_settings);
  void waitForChange(Lock& lock, std::optional<Clock::time_point> until);
  [[nodiscard]] bool isInterruptedHere() const;

  std::function<bool()> is_ended_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Order> order_;  ///< not yet carried out
  std::int64_t instant_ = 0;    ///< the one that is shown or, before that, was ordered
  bool is_making_ = false;      ///< whether an order is being carried out
  bool has_shown_ = false;      ///< whether an instant of that order has been shown
  bool is_playing_ = false;
  std::int64_t turns_ = 0;  ///< how many instants may be shown without waiting
  Clock::duration period_;
  Clock::time_point next_;  ///< when the next instant is shown while it plays
};

}  // namespace synthetic_dataset::programs
