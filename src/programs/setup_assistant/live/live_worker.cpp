#include "programs/setup_assistant/live/live_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {

LiveWorker::LiveWorker() : thread_([this] { work(); }) {}

LiveWorker::~LiveWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
  for (Waiting& each : waiting_) refuse(each);
}

std::shared_future<Value> LiveWorker::ask(const std::string& kind, Job job) {
  return put(kind, std::move(job), Earlier::kIsRefused);
}

std::shared_future<Value> LiveWorker::askOnce(const std::string& kind, Job job) {
  return put(kind, std::move(job), Earlier::kAnswersBoth);
}

std::shared_future<Value> LiveWorker::put(const std::string& kind, Job job, Earlier earlier) {
  Waiting asked{kind, std::move(job), {}, {}};
  asked.result = asked.answer.get_future().share();
  std::shared_future<Value> result = asked.result;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto same = std::find_if(waiting_.begin(), waiting_.end(),
                                   [&](const Waiting& each) { return each.kind == kind; });
    if (same == waiting_.end()) {
      waiting_.push_back(std::move(asked));
    } else if (earlier == Earlier::kAnswersBoth) {
      result = same->result;
    } else {
      refuse(*same);
      *same = std::move(asked);
    }
  }
  changed_.notify_all();
  return result;
}

void LiveWorker::refuse(Waiting& waiting) {
  waiting.answer.set_exception(
      std::make_exception_ptr(HttpError(409, "a later request of its kind has taken its turn")));
}

void LiveWorker::work() {
  run::LiveRun live;
  for (;;) {
    Waiting next;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return is_over_ || !waiting_.empty(); });
      if (is_over_) return;
      next = std::move(waiting_.front());
      waiting_.erase(waiting_.begin());
    }
    try {
      next.answer.set_value(next.job(live));
    } catch (...) {
      next.answer.set_exception(std::current_exception());
    }
  }
}

}  // namespace synthetic_dataset::programs
