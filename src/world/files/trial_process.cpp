#include "world/files/trial_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <string_view>

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

/// One end of a pipe.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

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

std::variant<std::string, Breakdown> tryWork(const std::function<std::string()>& work,
                                             const TrialLimits& limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return work();
  const Descriptor reading(ends[0]);
  Descriptor writing(ends[1]);
  static_cast<void>(fcntl(writing.number(), F_SETPIPE_SZ, kPipeSize));  // slower where it may not
  const pid_t child = fork();
  if (child < 0) return work();
  if (child == 0) run(work, limits, writing.number());
  writing.close();
  std::string answer = readAll(reading.number());
  const int status = statusOf(child);
  if (WIFSIGNALED(status)) return Breakdown{howItEnded(WTERMSIG(status), limits)};
  if (WEXITSTATUS(status) == kOutOfMemory) {
    return Breakdown{"needs more than " + std::to_string(limits.memory >> 20U) + " MiB of memory"};
  }
  if (WEXITSTATUS(status) == kError) throw Error(answer);
  if (WEXITSTATUS(status) != kDone) {
    return Breakdown{"ends with exit code " + std::to_string(WEXITSTATUS(status))};
  }
  return answer;
}

}  // namespace synthetic_dataset::world
