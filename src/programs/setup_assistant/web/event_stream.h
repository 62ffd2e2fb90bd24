#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::programs {

/// Events on their way to one page, as text/event-stream has them
/// (https://html.spec.whatwg.org/multipage/server-sent-events.html). Of events of one name that a
/// slow page has not fetched yet, the last one counts.
class EventStream {
 public:
  /// @param data  one line
  void push(const std::string& name, const std::string& data);

  /// Waits for events.
  /// @return their text, a comment after a while without any, so that a page that has gone is
  ///     noticed; nothing when the stream is closed
  [[nodiscard]] std::optional<std::string> next(std::chrono::milliseconds patience);

  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::string> waiting_;
  bool is_closed_ = false;
};

/// All pages that listen.
class EventHub {
 public:
  [[nodiscard]] std::shared_ptr<EventStream> subscribe();
  void publish(const std::string& name, const std::string& data);

  /// Ends all streams, and those that are made from now on.
  void close();

 private:
  std::mutex mutex_;
  std::vector<std::weak_ptr<EventStream>> streams_;
  bool is_closed_ = false;
};

}  // namespace synthetic_dataset::programs
