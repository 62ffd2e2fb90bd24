#include "programs/setup_assistant/run/child_program.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

constexpr int kNotFound = 127;  // as in shells

/// Runs in the child: calls only what is allowed after fork in a process with threads.
[[noreturn]] void becomeProgram(char* const* command, int output, pid_t parent) {
  // A terminal's Ctrl-C is for this server, which then stops the program in its own way.
  ::setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  // A shell that starts the server in the background makes it ignore SIGINT, which the program
  // would inherit.
  ::signal(SIGINT, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGINT);
  if (::getppid() != parent) ::_exit(kNotFound);  // the parent has died before that
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execv(command[0], command);
  ::_exit(kNotFound);
}

int exitCodeOf(int status) {
  constexpr int kSignalled = 128;
  return WIFSIGNALED(status) ? kSignalled + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::string programBesideThis(const std::string& name) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path program = self.parent_path() / name;
  if (std::filesystem::exists(program, error)) return program.string();
  throw Error("'" + program.string() + "': no such program");
}

ChildProgram::ChildProgram(const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    throw Error("cannot start '" + command[0] + "': " + std::generic_category().message(errno));
  }
  const pid_t parent = ::getpid();
  id_ = ::fork();
  if (id_ == 0) becomeProgram(words.data(), pipe[1], parent);
  const int reason = errno;
  ::close(pipe[1]);
  output_ = pipe[0];
  if (id_ > 0) return;
  ::close(output_);
  throw Error("cannot start '" + command[0] + "': " + std::generic_category().message(reason));
}

ChildProgram::~ChildProgram() {
  if (!is_waited_for_) {
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
  }
  ::close(output_);
}

int ChildProgram::wait() {
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  is_waited_for_ = true;
  return exitCodeOf(status);
}

void ChildProgram::read(const std::function<void(const std::string& line)>& take) const {
  std::string text;
  std::array<char, 4096> bytes{};
  for (;;) {
    const ssize_t count = ::read(output_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    text.append(bytes.data(), static_cast<std::size_t>(count));
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos;
         end = text.find('\n', begin)) {
      take(text.substr(begin, end - begin));
      begin = end + 1;
    }
    text.erase(0, begin);
  }
  if (!text.empty()) take(text);
}

}  // namespace synthetic_dataset::programs
