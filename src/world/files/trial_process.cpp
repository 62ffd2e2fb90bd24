#include "world/files/trial_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

// Exit codes of the child: how its answer is to be taken.
constexpr int kDone = 0;
constexpr int kOutOfMemory = 1;
constexpr int kError = 2;

constexpr int kPipeSize = 1 << 20;  // [byte]; the kernel's default is a sixteenth of it

/// A child that waits, and uses no processor time, gets so many times its limit.
constexpr unsigned kPatience = 4;

/// The process' address space [byte] (proc(5), statm).
std::uint64_t addressSpace() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// In the child: no core file, no output, no handlers, and an end.
void prepare(const TrialLimits& limits) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto seconds = static_cast<rlim_t>(limits.processor_time.count());
  const rlimit processor{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &processor);
  const rlim_t bytes = addressSpace() + limits.memory;
  const rlimit memory{bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGALRM, SIGPIPE}) {
    std::signal(signal, SIG_DFL);
  }
  alarm(kPatience * static_cast<unsigned>(limits.processor_time.count()));
}

void writeAll(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) _exit(kError);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void run(const std::function<std::string()>& work, const TrialLimits& limits, int to) {
  prepare(limits);
  int code = kDone;
  try {
    writeAll(to, work());
  } catch (const std::bad_alloc&) {
    code = kOutOfMemory;
  } catch (const std::exception& error) {
    writeAll(to, error.what());
    code = kError;
  }
  _exit(code);  // without the parent's exit handlers and buffers
}

std::string readAll(int from) {
  std::string bytes;
  std::array<char, 1U << 16U> buffer{};
  while (true) {
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

int statusOf(pid_t child) {
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(child, &status, 0);
  } while (ended < 0 && errno == EINTR);
  if (ended != child) throw Error("a process of its own cannot be waited for");
  return status;
}

std::string howItEnded(int signal, const TrialLimits& limits) {
  if (signal == SIGXCPU || signal == SIGKILL || signal == SIGALRM) {
    return "does not end within " + std::to_string(limits.processor_time.count()) + " s";
  }
  return std::string("crashes (") + strsignal(signal) + ")";
}

}  // namespace

TrialProcess::TrialProcess(std::function<std::string()> work, const TrialLimits& limits)
    : work_(std::move(work)), limits_(limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  const auto [reading, writing] = ends;
  static_cast<void>(fcntl(writing, F_SETPIPE_SZ, kPipeSize));  // slower where it may not
  child_ = fork();
  if (child_ == 0) run(work_, limits_, writing);
  close(writing);
  if (child_ < 0) {
    close(reading);
  } else {
    reading_ = reading;
  }
}

TrialProcess::TrialProcess(TrialProcess&& other) noexcept
    : work_(std::move(other.work_)),
      limits_(other.limits_),
      child_(std::exchange(other.child_, -1)),
      reading_(std::exchange(other.reading_, -1)) {}

TrialProcess::~TrialProcess() {
  if (child_ < 0) return;
  kill(child_, SIGKILL);
  close(reading_);
  while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::variant<std::string, Breakdown> TrialProcess::finish() {
  if (child_ < 0) return work_();
  std::string answer = readAll(reading_);
  close(std::exchange(reading_, -1));
  const int status = statusOf(std::exchange(child_, -1));
  if (WIFSIGNALED(status)) return Breakdown{howItEnded(WTERMSIG(status), limits_)};
  if (WEXITSTATUS(status) == kOutOfMemory) {
    return Breakdown{"needs more than " + std::to_string(limits_.memory >> 20U) + " MiB of memory"};
  }
  if (WEXITSTATUS(status) == kError) throw Error(answer);
  if (WEXITSTATUS(status) != kDone) {
    return Breakdown{"ends with exit code " + std::to_string(WEXITSTATUS(status))};
  }
  return answer;
}

std::variant<std::string, Breakdown> tryWork(const std::function<std::string()>& work,
                                             const TrialLimits& limits) {
  return TrialProcess(work, limits).finish();
}

}  // namespace synthetic_dataset::world
