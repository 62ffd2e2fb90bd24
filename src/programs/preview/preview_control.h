#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>

namespace synthetic_dataset::programs {

/// Which instant of a run is shown, and when the next one is.
///
/// Users give commands from any thread. The thread that makes scenes asks for orders, and makes the
/// scenes from an order's instant on until it is interrupted; the thread that shows them waits for
/// each instant's turn.
class PreviewControl {
 public:
  /// What to make: the run's scenes from an instant on.
  struct Order {
    std::int64_t instant = 0;
    bool reads_settings = false;  ///< anew
  };

  enum class State { kLoading, kStanding, kPlaying };

  /// @param is_ended  asked now and then while something waits: whether the program is to end
  /// @param rate  instants per second when it plays [Hz], above 0
  PreviewControl(std::function<bool()> is_ended, double rate);

  void step();
  void stepBack();
  void play();
  void pause();
  void jumpTo(std::int64_t instant);
  void reload();

  /// The instant that is shown has to be made again, for what was not made of it.
  void makeAgain();

  /// @throws Error unless it is above 0 and finite
  void setRate(double rate);

  [[nodiscard]] State state() const;

  // For the thread that makes scenes:

  /// Waits until there is something to make. Nothing: the program ends.
  [[nodiscard]] std::optional<Order> awaitOrder();

  /// Whether there is another order, or the program ends.
  [[nodiscard]] bool isInterrupted() const;

  // For the thread that shows them:

  /// Waits until an instant, the next one of the order that is carried out, is to be shown.
  /// @return false when it is not, as there is another order
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
  std::int64_t instant_ = 0;    ///< that is shown or, before that, was ordered
  bool is_making_ = false;      ///< what was ordered
  bool has_shown_ = false;      ///< something of that
  bool is_playing_ = false;
  std::int64_t turns_ = 0;  ///< instants that may be shown at once
  Clock::duration period_;
  Clock::time_point next_;  ///< when the next instant is shown while it plays
};

}  // namespace synthetic_dataset::programs
