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

/// The only thread that draws, since OpenGL is bound to it. Of waiting requests of one kind, only
/// the latest is carried out.
class LiveWorker {
 public:
  using Job = std::function<Value(run::LiveRun& live)>;

  LiveWorker();

  /// Calls close() first.
  ~LiveWorker();
  LiveWorker(const LiveWorker&) = delete;
  LiveWorker& operator=(const LiveWorker&) = delete;

  /// Refuses requests from now on, also waiting ones, and interrupts a set-up in progress.
  void close();

  /// Has a job done in that thread.
  /// @param kind  a waiting job of the same kind is refused
  /// @return what the job returns or throws; HttpError 409 when a later one has taken its place
  std::shared_future<Value> ask(const std::string& kind, Job job);

  /// Like ask(), but if a job of the same kind is waiting, the answer is that job's: for kinds
  /// whose jobs all do the same.
  std::shared_future<Value> askOnce(const std::string& kind, Job job);

 private:
  struct Waiting {
    std::string kind;
    Job job;
    std::promise<Value> answer;
    std::shared_future<Value> result;
  };

  /// What happens to a waiting job of the same kind.
  enum class Earlier { kIsRefused, kAnswersBoth };

  std::shared_future<Value> put(const std::string& kind, Job job, Earlier earlier);
  void work();
  static void refuse(Waiting& waiting, const char* why);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Waiting> waiting_;  ///< in the order in which their kinds were first asked for
  std::atomic<bool> is_over_ = false;
  std::thread thread_;  ///< declared last: it uses the other members
};

}  // namespace synthetic_dataset::programs
