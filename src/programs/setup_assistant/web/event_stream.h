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

/// Events on their way to one page, in the format of text/event-stream
/// (https://html.spec.whatwg.org/multipage/server-sent-events.html). Of several events of one name
/// that a slow page has not fetched yet, only the last one is kept.
class EventStream {
 public:
  /// @param data  one line
  void push(const std::string& name, const std::string& data);

  /// Waits for events.
  /// @return their text; a comment if there are none within `patience`, so that a page that has
  ///     been closed is noticed; nothing when the stream is closed
  [[nodiscard]] std::optional<std::string> next(std::chrono::milliseconds patience);

  void close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::string> waiting_;
  bool is_closed_ = false;
};

/// The event streams of all pages.
class EventHub {
 public:
  [[nodiscard]] std::shared_ptr<EventStream> subscribe();
  void publish(const std::string& name, const std::string& data);

  /// Closes all streams, including those that are opened from now on.
  void close();

 private:
  std::mutex mutex_;
  std::vector<std::weak_ptr<EventStream>> streams_;
  bool is_closed_ = false;
};

}  // namespace synthetic_dataset::programs
