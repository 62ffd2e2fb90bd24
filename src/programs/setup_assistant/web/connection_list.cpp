#include "programs/setup_assistant/web/connection_list.h"

#include <sys/socket.h>

namespace synthetic_dataset::programs {

void ConnectionList::open(int socket) {
  const std::lock_guard<std::mutex> lock(mutex_);
  strangers_.push_back(socket);
  if (strangers_.size() <= kMostStrangers) return;
  ::shutdown(strangers_.front(), SHUT_RDWR);  // the thread that serves it notices, and closes it
  strangers_.pop_front();
}

void ConnectionList::admit(int socket) { close(socket); }

void ConnectionList::close(int socket) {
  const std::lock_guard<std::mutex> lock(mutex_);
  strangers_.remove(socket);
}

}  // namespace synthetic_dataset::programs
