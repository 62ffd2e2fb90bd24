#include "world/trial_process.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace synthetic_dataset::world {
namespace {

constexpr int kOutOfMemory = 1;  // exit code of the child

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
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
}

[[noreturn]] void run(const std::function<void()>& work, const TrialLimits& limits) {
  prepare(limits);
  try {
    work();
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (...) {
    // An exception is an orderly end; who does the work again meets it again.
  }
  _exit(0);  // without the parent's exit handlers and buffers
}

}  // namespace

std::optional<std::string> breakdownOf(const std::function<void()>& work,
                                       const TrialLimits& limits) {
  const pid_t child = fork();
  if (child < 0) return std::nullopt;  // no process to be had: do without the trial
  if (child == 0) run(work, limits);
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(child, &status, 0);
  } while (ended < 0 && errno == EINTR);
  if (ended != child) return std::nullopt;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
    return "needs more than " + std::to_string(limits.memory >> 20U) + " MiB of memory";
  }
  if (!WIFSIGNALED(status)) return std::nullopt;
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) {
    return "does not end within " + std::to_string(limits.processor_time.count()) + " s";
  }
  return std::string("crashes (") + strsignal(signal) + ")";
}

}  // namespace synthetic_dataset::world
