#include "programs/setup_assistant/web/event_stream.h"

#include <algorithm>

namespace synthetic_dataset::programs {

void EventStream::push(const std::string& name, const std::string& data) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_[name] = data;
  }
  changed_.notify_all();
}

std::optional<std::string> EventStream::next(std::chrono::milliseconds patience) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return is_closed_ || !waiting_.empty(); });
  if (is_closed_) return std::nullopt;
  if (waiting_.empty()) return ": nothing new\n\n";
  std::string text;
  for (const auto& [name, data] : waiting_) text += "event: " + name + "\ndata: " + data + "\n\n";
  waiting_.clear();
  return text;
}

void EventStream::close() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_closed_ = true;
  }
  changed_.notify_all();
}

std::shared_ptr<EventStream> EventHub::subscribe() {
  auto stream = std::make_shared<EventStream>();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_closed_) stream->close();
  streams_.erase(std::remove_if(streams_.begin(), streams_.end(),
                                [](const auto& each) { return each.expired(); }),
                 streams_.end());
  streams_.push_back(stream);
  return stream;
}

void EventHub::publish(const std::string& name, const std::string& data) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& each : streams_) {
    if (const auto stream = each.lock()) stream->push(name, data);
  }
}

void EventHub::close() {
  const std::lock_guard<std::mutex> lock(mutex_);
  is_closed_ = true;
  for (const auto& each : streams_) {
    if (const auto stream = each.lock()) stream->close();
  }
}

}  // namespace synthetic_dataset::programs
