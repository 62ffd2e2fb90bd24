#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "run/live/live_run.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The one thread that draws: OpenGL belongs to it. Of requests of a kind that wait, the latest one
/// wins.
class LiveWorker {
 public:
  using Job = std::function<Value(run::LiveRun& live)>;

  LiveWorker();

  /// Closes it first.
  ~LiveWorker();
  LiveWorker(const LiveWorker&) = delete;
  LiveWorker& operator=(const LiveWorker&) = delete;

  /// Refuses requests from now on, those that wait, too; what is being set up is broken off.
  void close();

  /// Does a job in that thread.
  /// @param kind  a job of the same kind that waits is refused
  /// @return what the job returns or throws; HttpError 409 when a later one has taken its turn
  std::shared_future<Value> ask(const std::string& kind, Job job);

  /// The same, but the answer is that of a job of the same kind that waits, if there is one: for
  /// kinds whose jobs all do the same.
  std::shared_future<Value> askOnce(const std::string& kind, Job job);

 private:
  struct Waiting {
    std::string kind;
    Job job;
    std::promise<Value> answer;
    std::shared_future<Value> result;
  };

  /// What becomes of a job of the same kind that waits.
  enum class Earlier { kIsRefused, kAnswersBoth };

  std::shared_future<Value> put(const std::string& kind, Job job, Earlier earlier);
  void work();
  static void refuse(Waiting& waiting, const char* why);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting> waiting_;  ///< in the order in which their kinds were first asked for
  std::atomic<bool> is_over_ = false;
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace synthetic_dataset::programs
