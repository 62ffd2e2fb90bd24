#pragma once

#include <cstddef>
#include <list>
#include <mutex>

namespace synthetic_dataset::programs {

/// The open connections of a server on which nobody has shown the token. These strangers cannot
/// keep others out: if there are too many, the oldest of them is shut down.
class ConnectionList {
 public:
  static constexpr std::size_t kMostStrangers = 64;

  /// Adds a new connection.
  void open(int socket);

  /// Removes a connection on which a request was admitted.
  void admit(int socket);

  /// Forgets a connection that closes; its descriptor may be reused afterwards.
  void close(int socket);

 private:
  std::mutex mutex_;
  std::list<int> strangers_;  ///< the oldest first
};

}  // namespace synthetic_dataset::programs
