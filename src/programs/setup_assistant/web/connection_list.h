#pragma once

#include <cstddef>
#include <list>
#include <mutex>

namespace synthetic_dataset::programs {

/// The open connections of a server. Those on which nobody has shown the token are strangers', who
/// cannot keep others out: where there are too many, the oldest of them is ended.
class ConnectionList {
 public:
  static constexpr std::size_t kMostStrangers = 64;

  /// A connection has begun.
  void open(int socket);

  /// A request on it got through.
  void admit(int socket);

  /// It ends; its number may be another one's afterwards.
  void close(int socket);

 private:
  std::mutex mutex_;
  std::list<int> strangers_;  ///< the oldest first
};

}  // namespace synthetic_dataset::programs
