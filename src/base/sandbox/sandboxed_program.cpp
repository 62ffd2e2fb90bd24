#include "base/sandbox/sandboxed_program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/sandbox/byte_stream.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

constexpr int kNoSuchProgram = 127;

/// Both ends of a pipe.
struct Pipe {
  int reading = -1;
  int writing = -1;

  Pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
      throw Error(std::string("cannot open a pipe: ") + std::strerror(errno));
    }
    reading = ends[0];
    writing = ends[1];
  }
};

[[noreturn]] void become(const std::vector<std::string>& command, int output, int errors) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& each : command) arguments.push_back(const_cast<char*>(each.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments.front(), arguments.data());
  _exit(kNoSuchProgram);
}

/// Reads both pipes to their ends.
void readBoth(int output, int errors, ProgramResult& to) {
  std::array<pollfd, 2> ends{pollfd{output, POLLIN, 0}, pollfd{errors, POLLIN, 0}};
  std::array<char, 1U << 16U> buffer{};
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    if (poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) break;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd < 0 || ends[i].revents == 0) continue;
      const ssize_t count = read(ends[i].fd, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        ends[i].fd = -1;
      } else {
        (i == 0 ? to.output : to.errors).append(buffer.data(), static_cast<std::size_t>(count));
      }
    }
  }
}

/// Runs in the sandboxed process, whose limits the program inherits.
std::string run(const std::vector<std::string>& command) {
  const Pipe output;
  const Pipe errors;
  const pid_t program = fork();
  if (program < 0) throw Error(std::string("cannot start a process: ") + std::strerror(errno));
  if (program == 0) become(command, output.writing, errors.writing);
  close(output.writing);
  close(errors.writing);
  ProgramResult result;
  readBoth(output.reading, errors.reading, result);
  int status = 0;
  while (waitpid(program, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    std::raise(WTERMSIG(status));  // this process ends in the same way as the program
  result.exit_code = WEXITSTATUS(status);
  ByteWriter writer;
  writer.number(result.exit_code);
  writer.text(result.output);
  writer.text(result.errors);
  return writer.take();
}

}  // namespace

std::variant<ProgramResult, Crash> runSandboxedProgram(const std::vector<std::string>& command,
                                                       SandboxLimits limits) {
  // The process only waits for the program, without using the processor, and must not be restarted
  // for that.
  limits.idle = 8 * std::chrono::milliseconds(limits.processor_time);
  const auto answer = runSandboxed([&] { return run(command); }, limits);
  if (const auto* crash = std::get_if<Crash>(&answer)) return *crash;
  ByteReader reader(std::get<std::string>(answer));
  ProgramResult result;
  result.exit_code = reader.number<int>();
  result.output = reader.text();
  result.errors = reader.text();
  return result;
}

}  // namespace synthetic_dataset::base
