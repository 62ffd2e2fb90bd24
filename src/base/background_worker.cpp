#include "base/background_worker.h"

#include <system_error>
#include <utility>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

std::thread started(const std::function<void()>& work) {
  try {
    return std::thread(work);
  } catch (const std::system_error& error) {
    throw Error("the system starts no more threads for this process: " + error.code().message() +
                "; raise the limit of processes (ulimit -u), of memory (ulimit -v), or of the "
                "container");
  }
}

}  // namespace

BackgroundWorker::BackgroundWorker(std::size_t most_waiting)
    : most_waiting_(most_waiting), thread_(started([this] { work(); })) {}

BackgroundWorker::~BackgroundWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWorker::add(Job job) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || waiting_.size() < most_waiting_; });
  rethrow();
  waiting_.push_back(std::move(job));
  lock.unlock();
  changed_.notify_all();
}

void BackgroundWorker::finish() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || (waiting_.empty() && !working_); });
  rethrow();
}

/// Called with the mutex held.
void BackgroundWorker::rethrow() {
  if (failure_) std::rethrow_exception(failure_);
}

void BackgroundWorker::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (ended_) return;
    Job job = std::move(waiting_.front());
    waiting_.pop_front();
    working_ = true;
    lock.unlock();
    std::exception_ptr failure;
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    job = nullptr;  // free what it owns before it is reported as done
    lock.lock();
    working_ = false;
    if (failure) {
      failure_ = failure;
      waiting_.clear();
    }
    changed_.notify_all();
  }
}

}  // namespace synthetic_dataset::base
