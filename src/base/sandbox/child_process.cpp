#include "base/sandbox/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace synthetic_dataset::base {
namespace {

bool is_sandboxed = false;

/// The process' address space [byte] (proc(5), statm).
std::uint64_t addressSpace() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace

void becomeSandboxed(const SandboxLimits& limits) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const rlim_t bytes = addressSpace() + limits.memory;
  const rlimit memory{bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGALRM, SIGPIPE}) {
    std::signal(signal, SIG_DFL);
  }
  is_sandboxed = true;
}

bool isSandboxed() { return is_sandboxed; }

std::int64_t cpuTimeIfSleeping(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string stat;
  std::getline(file, stat);
  // The name, in brackets, may hold anything; the state follows it, the two times are 11 further.
  std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
  std::string state;
  std::string other;
  std::int64_t user = 0;
  std::int64_t system = 0;
  fields >> state;
  for (int i = 0; i < 10; ++i) fields >> other;
  fields >> user >> system;
  return state == "S" && fields ? user + system : -1;
}

void endChild(pid_t child) noexcept {
  kill(child, SIGKILL);
  while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace synthetic_dataset::base
