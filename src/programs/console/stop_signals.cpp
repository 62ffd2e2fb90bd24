#include "programs/console/stop_signals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <string_view>

#include <unistd.h>

namespace synthetic_dataset::programs::stop_signals {
namespace {

constexpr int kSignalExitOffset = 128;  // of exit codes after a signal, as in shells
constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

// A signal handler may use only what lies in memory already, and lock-free atomics.
std::atomic<int> g_requested{0};
std::atomic<bool> g_scenes_are_made{false};
std::atomic<pid_t> g_process{0};
std::atomic<bool> g_is_silent{false};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

void print(std::string_view message) {
  while (!message.empty() && !g_is_silent) {
    const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    if (written <= 0) return;  // nobody reads any more
    message.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void endNow(int signal, std::string_view message) {
  print(message);
  _exit(kSignalExitOffset + signal);
}

void onSignal(int signal) {
  const int error = errno;
  if (getpid() != g_process) {  // forked to read a file: prints nothing, its parent sees it end
    std::signal(signal, SIG_DFL);
    raise(signal);  // delivered when this handler returns
    return;
  }
  if (!g_scenes_are_made) {
    endNow(signal, "\ngenerate: stopped before the first scene\n");
  }
  int none = 0;
  if (!g_requested.compare_exchange_strong(none, signal)) {
    endNow(signal,
           "\ngenerate: stopped at once; run the same command again to go on "
           "(`if_exists: overwrite` starts anew)\n");
  }
  print(
      "\ngenerate: stopping when this scene is written, or the dataset's last files; the next "
      "signal stops at once\n");
  errno = error;
}

}  // namespace

void ignoreFailedWriting() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error of the call that writes
}

void install(Messages messages) {
  g_process = getpid();
  g_is_silent = messages == Messages::kOff;
  ignoreFailedWriting();
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;  // interrupted reads and writes go on
  sigemptyset(&action.sa_mask);
  for (const int signal : kSignals) sigaddset(&action.sa_mask, signal);
  for (const int signal : kSignals) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

void stopAfterScene() { g_scenes_are_made = true; }

int requested() { return g_requested; }

const char* name(int signal) {
  switch (signal) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    default:
      return "a signal";
  }
}

}  // namespace synthetic_dataset::programs::stop_signals
