#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace synthetic_dataset::programs {

/// Calls a function several times a second, in a thread of its own, until it is destroyed.
class Ticker {
 public:
  explicit Ticker(std::function<void()> tick);
  ~Ticker();
  Ticker(const Ticker&) = delete;
  Ticker& operator=(const Ticker&) = delete;

 private:
  void run(const std::function<void()>& tick);

  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_over_ = false;
  std::thread thread_;  ///< declared last: it uses the other members
};

}  // namespace synthetic_dataset::programs
