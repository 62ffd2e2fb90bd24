#include "programs/setup_assistant/live/live_worker.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/stages.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {
namespace {

constexpr const char* kOver = "setup_assistant is stopping";

}  // namespace

LiveWorker::LiveWorker() : thread_([this] { work(); }) {}

LiveWorker::~LiveWorker() {
  close();
  thread_.join();
}

void LiveWorker::close() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
    for (Waiting& each : waiting_) refuse(each, kOver);
    waiting_.clear();
  }
  changed_.notify_all();
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
    if (is_over_) {
      refuse(asked, kOver);
      return result;
    }
    const auto same = std::find_if(waiting_.begin(), waiting_.end(),
                                   [&](const Waiting& each) { return each.kind == kind; });
    if (same == waiting_.end()) {
      waiting_.push_back(std::move(asked));
    } else if (earlier == Earlier::kAnswersBoth) {
      result = same->result;
    } else {
      refuse(*same, "a later request of its kind has replaced it");
      *same = std::move(asked);
    }
  }
  changed_.notify_all();
  return result;
}

void LiveWorker::refuse(Waiting& waiting, const char* why) {
  waiting.answer.set_exception(std::make_exception_ptr(HttpError(409, why)));
}

void LiveWorker::work() {
  run::LiveRun live({}, [this](const std::string& /*stage*/) {
    if (is_over_) throw base::Interrupted();
  });
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
    } catch (const base::Interrupted&) {
      refuse(next, kOver);
    } catch (...) {
      next.answer.set_exception(std::current_exception());
    }
  }
}

}  // namespace synthetic_dataset::programs
