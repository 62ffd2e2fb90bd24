#include "base/sandbox/sandboxed_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/sandbox/child_process.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

// Exit codes of the child, which tell how to interpret its answer.
constexpr int kDone = 0;
constexpr int kOutOfMemory = 1;
constexpr int kError = 2;

constexpr int kPipeSize = 1 << 20;  // [byte]; the kernel's default is a sixteenth of this

/// The limit on a child's elapsed time, as a multiple of its processor time limit.
constexpr unsigned kPatience = 4;

/// How often a child that waits without using the processor is restarted.
constexpr int kRestarts = 3;

constexpr std::chrono::milliseconds kForEver{-1};  // poll(2)

/// Called in the child, which ends at the latest with its parent.
void prepare(const SandboxLimits& limits, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kError);  // it has ended already
  const auto seconds = static_cast<rlim_t>(limits.processor_time.count());
  const rlimit processor{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &processor);
  becomeSandboxed(limits);
  alarm(kPatience * static_cast<unsigned>(limits.processor_time.count()));
}

void writeAll(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) _exit(kError);
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

[[noreturn]] void run(const std::function<std::string()>& work, const SandboxLimits& limits,
                      pid_t parent, int to) {
  prepare(limits, parent);
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

/// What a child sends until it ends; nullopt if, from one `interval` to the next, it sends nothing
/// and waits without having used the processor.
std::optional<std::string> readAll(int from, pid_t child, std::chrono::milliseconds interval) {
  std::string bytes;
  std::array<char, 1U << 16U> buffer{};
  std::int64_t before = -1;
  while (true) {
    pollfd end{from, POLLIN, 0};
    const int ready = poll(&end, 1, static_cast<int>(interval.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      const std::int64_t now = cpuTimeIfSleeping(child);
      if (now >= 0 && now == before) return std::nullopt;
      before = now;
      continue;
    }
    before = -1;
    const ssize_t count = read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

struct End {
  int status = 0;         ///< as returned by wait(2)
  std::int64_t time = 0;  ///< of the processor [s]
};

End endOf(pid_t child) {
  End end;
  rusage usage{};
  pid_t ended = 0;
  do {
    ended = wait4(child, &end.status, 0, &usage);
  } while (ended < 0 && errno == EINTR);
  if (ended != child) throw Error("a child process cannot be waited for");
  end.time = usage.ru_utime.tv_sec + usage.ru_stime.tv_sec;
  return end;
}

std::string howItEnded(const End& end, const SandboxLimits& limits) {
  const int signal = WTERMSIG(end.status);
  // The kernel kills a process that exceeds its limit, and also one for which it has no memory.
  const bool used_its_time = end.time >= limits.processor_time.count();
  if (signal == SIGXCPU || signal == SIGALRM || (signal == SIGKILL && used_its_time)) {
    return "does not end within " + std::to_string(limits.processor_time.count()) + " s";
  }
  if (signal == SIGKILL) return "is killed (the machine may be short of memory)";
  return std::string("crashes (") + strsignal(signal) + ")";
}

}  // namespace

SandboxedProcess::SandboxedProcess(std::function<std::string()> work, const SandboxLimits& limits)
    : work_(std::move(work)), limits_(limits) {
  start();
}

void SandboxedProcess::start() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
  const auto [reading, writing] = ends;
  static_cast<void>(fcntl(writing, F_SETPIPE_SZ, kPipeSize));  // slower if that is not permitted
  const pid_t parent = getpid();
  child_ = fork();
  if (child_ == 0) run(work_, limits_, parent, writing);
  close(writing);
  if (child_ < 0) {
    close(reading);
  } else {
    reading_ = reading;
  }
}

SandboxedProcess::SandboxedProcess(SandboxedProcess&& other) noexcept
    : work_(std::move(other.work_)),
      limits_(other.limits_),
      child_(std::exchange(other.child_, -1)),
      reading_(std::exchange(other.reading_, -1)) {}

SandboxedProcess::~SandboxedProcess() { stop(); }

void SandboxedProcess::stop() noexcept {
  if (child_ < 0) return;
  close(std::exchange(reading_, -1));
  endChild(std::exchange(child_, -1));
}

std::optional<std::string> SandboxedProcess::receive() {
  for (int restarts = 0; child_ >= 0; ++restarts) {
    const auto interval = restarts < kRestarts ? limits_.idle : kForEver;
    std::optional<std::string> answer = readAll(reading_, child_, interval);
    if (answer) return answer;
    stop();
    start();
  }
  return std::nullopt;
}

std::variant<std::string, Crash> SandboxedProcess::finish() {
  std::optional<std::string> answer = receive();
  if (!answer) return work_();
  close(std::exchange(reading_, -1));
  const End end = endOf(std::exchange(child_, -1));
  const int status = end.status;
  if (WIFSIGNALED(status)) return Crash{howItEnded(end, limits_)};
  if (WEXITSTATUS(status) == kOutOfMemory) {
    return Crash{"needs more than " + std::to_string(limits_.memory >> 20U) + " MiB of memory"};
  }
  if (WEXITSTATUS(status) == kError) throw Error(*answer);
  if (WEXITSTATUS(status) != kDone) {
    return Crash{"ends with exit code " + std::to_string(WEXITSTATUS(status))};
  }
  return std::move(*answer);
}

void limitSandboxTime(std::chrono::seconds processor_time) {
  rlimit limit{};
  rusage usage{};
  if (!isSandboxed() || getrlimit(RLIMIT_CPU, &limit) != 0 || getrusage(RUSAGE_SELF, &usage) != 0) {
    return;
  }
  const auto used = static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + 1;
  const rlim_t end = used + static_cast<rlim_t>(processor_time.count());
  limit.rlim_cur = std::min(end, limit.rlim_max);
  setrlimit(RLIMIT_CPU, &limit);
  alarm(kPatience * static_cast<unsigned>(processor_time.count()));
}

std::variant<std::string, Crash> runSandboxed(const std::function<std::string()>& work,
                                              const SandboxLimits& limits) {
  return SandboxedProcess(work, limits).finish();
}

}  // namespace synthetic_dataset::base
