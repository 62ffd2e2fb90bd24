#include "base/sandbox/kept_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <utility>
#include <vector>

#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/sandbox/child_process.h"

namespace synthetic_dataset::base {
namespace {

/// Precedes each request and each answer.
struct Head {
  std::uint64_t size = 0;  // [byte] of what follows
  bool is_done = true;
};

/// @param is_ready  waits until data can be sent or received; the transfer is aborted if it returns
///     false
template <class IsReady>
bool sendAll(int to, const void* data, std::size_t size, const IsReady& is_ready) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    if (!is_ready(POLLOUT)) return false;
    const ssize_t sent = send(to, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (sent <= 0) return false;
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

template <class IsReady>
bool sendMessage(int to, std::string_view content, bool is_done, const IsReady& is_ready) {
  const Head head{content.size(), is_done};
  return sendAll(to, &head, sizeof(head), is_ready) &&
         sendAll(to, content.data(), content.size(), is_ready);
}

template <class IsReady>
bool receiveAll(int from, void* data, std::size_t size, const IsReady& is_ready) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    if (!is_ready(POLLIN)) return false;
    const ssize_t count = recv(from, bytes, size, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// Closes the parent's files: while this process keeps them open, files would stay locked and ports
/// in use.
void closeAllBut(int kept) {
  std::vector<int> open;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    open.push_back(std::atoi(entry.path().filename().c_str()));
  }
  for (const int each : open) {
    if (each > STDERR_FILENO && each != kept) close(each);
  }
}

/// Answers requests until the other end is closed.
[[noreturn]] void answerAll(const std::function<std::string(std::string_view)>& work,
                            const SandboxLimits& limits, int socket) {
  closeAllBut(socket);
  becomeSandboxed(limits);
  const auto is_ready = [socket](short event) {
    pollfd end{socket, event, 0};
    while (poll(&end, 1, -1) < 0 && errno == EINTR) {
    }
    return true;
  };
  Head head;
  while (receiveAll(socket, &head, sizeof(head), is_ready)) {
    std::string answer;
    bool is_done = true;
    try {
      std::string request(head.size, '\0');
      if (!receiveAll(socket, request.data(), request.size(), is_ready)) break;
      limitSandboxTime(limits.processor_time);
      answer = work(request);
    } catch (const std::exception&) {
      is_done = false;
    }
    alarm(0);
    if (!sendMessage(socket, answer, is_done, is_ready)) break;
  }
  _exit(0);  // without the parent's exit handlers and buffers
}

}  // namespace

KeptProcess::KeptProcess(std::function<std::string(std::string_view)> work,
                         const SandboxLimits& limits)
    : work_(std::move(work)), limits_(limits) {}

KeptProcess::~KeptProcess() { stop(); }

bool KeptProcess::isThere() const { return child_ >= 0 && owner_ == getpid(); }

void KeptProcess::launch() {
  stop();
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  const auto [own, its] = ends;
  owner_ = getpid();
  child_ = fork();
  if (child_ == 0) answerAll(work_, limits_, its);
  close(its);
  if (child_ < 0) {
    close(own);
  } else {
    socket_ = own;
  }
}

void KeptProcess::stop() noexcept {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (isThere()) endChild(child_);
  child_ = -1;
}

std::optional<std::string> KeptProcess::ask(std::string_view request) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!isThere()) launch();
  if (!isThere()) return std::nullopt;
  std::optional<std::string> answer = answerTo(request);
  if (!answer) stop();
  return answer;
}

/// A process that neither receives nor sends anything and sleeps without using the processor is
/// waiting for a lock that nothing will ever unlock there; see SandboxLimits::idle.
std::optional<std::string> KeptProcess::answerTo(std::string_view request) const {
  std::int64_t before = -1;
  const auto it_works = [&](short event) {
    while (true) {
      pollfd end{socket_, event, 0};
      const int ready = poll(&end, 1, static_cast<int>(limits_.idle.count()));
      if (ready > 0) return true;
      if (ready < 0 && errno != EINTR) return false;
      const std::int64_t now = cpuTimeIfSleeping(child_);
      if (ready == 0 && now >= 0 && now == before) return false;
      before = now;
    }
  };
  Head head;
  if (!sendMessage(socket_, request, true, it_works) ||
      !receiveAll(socket_, &head, sizeof(head), it_works) || !head.is_done) {
    return std::nullopt;
  }
  std::string answer(head.size, '\0');
  if (!receiveAll(socket_, answer.data(), answer.size(), it_works)) return std::nullopt;
  return answer;
}

}  // namespace synthetic_dataset::base
