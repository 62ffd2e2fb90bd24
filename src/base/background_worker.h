#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace synthetic_dataset::base {

/// Does jobs one after another, in the order added, in a thread of its own.
///
/// The next call rethrows what a job has thrown; the jobs after it are not done.
class BackgroundWorker {
 public:
  using Job = std::function<void()>;

  /// @param most_waiting  jobs that may wait at a time, at least 1
  /// @throws Error if the system cannot start a thread
  explicit BackgroundWorker(std::size_t most_waiting);

  /// Finishes the job in progress; those that wait are not done.
  ~BackgroundWorker();
  BackgroundWorker(const BackgroundWorker&) = delete;
  BackgroundWorker& operator=(const BackgroundWorker&) = delete;

  /// Blocks while too many jobs are waiting.
  /// @throws what an earlier job threw; this one is then not done
  void add(Job job);

  /// Waits until all jobs are done.
  /// @throws what one of them threw
  void finish();

 private:
  void work();
  void rethrow();

  std::size_t most_waiting_;
  std::mutex mutex_;
  std::condition_variable changed_;  ///< any of the following
  std::deque<Job> waiting_;
  bool working_ = false;
  bool ended_ = false;
  std::exception_ptr failure_;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace synthetic_dataset::base
