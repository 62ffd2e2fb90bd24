#include "programs/console/processes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "programs/console/stop_signals.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

enum class Kind : char { kInfo, kWarning, kError, kStage, kScenes, kScene };

// Exit codes of a process.
constexpr int kDone = 0;
constexpr int kFailed = 1;  // errors have been sent
constexpr int kStopped = 2;

struct Message {
  Kind kind = Kind::kInfo;
  std::string text;
};

// A message is its kind, the size of its text in 4 bytes, and the text.
constexpr std::size_t kHeader = 1 + sizeof(std::uint32_t);

void send(int pipe, Kind kind, const std::string& text) {
  const auto size = static_cast<std::uint32_t>(text.size());
  std::string bytes(kHeader, static_cast<char>(kind));
  std::memcpy(&bytes[1], &size, sizeof(size));
  bytes += text;
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // nobody reads any more: a signal is on its way
    sent += static_cast<std::size_t>(count);
  }
}

/// Takes the first whole message from the bytes received so far.
std::optional<Message> takeMessage(std::string& bytes) {
  if (bytes.size() < kHeader) return std::nullopt;
  std::uint32_t size = 0;
  std::memcpy(&size, &bytes[1], sizeof(size));
  if (bytes.size() < kHeader + size) return std::nullopt;
  Message message{static_cast<Kind>(bytes[0]), bytes.substr(kHeader, size)};
  bytes.erase(0, kHeader + size);
  return message;
}

/// In a child process: sends reports to its parent.
class SendingReporter : public run::Reporter {
 public:
  explicit SendingReporter(int pipe) : pipe_(pipe) {}

  void info(const std::string& message) override { send(pipe_, Kind::kInfo, message); }
  void warning(const std::string& message) override { send(pipe_, Kind::kWarning, message); }
  void stage(const std::string& what) override { send(pipe_, Kind::kStage, what); }
  void progress(std::int64_t /*scenes_done*/, std::int64_t scenes) override {
    if (!has_begun_) {
      stop_signals::stopAfterScene();
      send(pipe_, Kind::kScenes, std::to_string(scenes));
    } else {
      send(pipe_, Kind::kScene, "");
    }
    has_begun_ = true;
  }
  [[nodiscard]] bool stopRequested() const override { return stop_signals::requested() != 0; }

 private:
  int pipe_;
  bool has_begun_ = false;
};

/// Tells a waiting process that it is its turn.
class Turn {
 public:
  Turn() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw Error("cannot make a pipe for a process");
  }
  ~Turn() {
    for (const int end : ends_) ::close(end);
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  void give() const {
    while (::write(ends_[1], "x", 1) < 0 && errno == EINTR) {
    }
  }

  /// Called in the waiting process, which a signal may end before.
  void wait() const {
    char byte = 0;
    while (::read(ends_[0], &byte, 1) < 0 && errno == EINTR) {
    }
  }

 private:
  std::array<int, 2> ends_{};
};

[[noreturn]] void runProcess(int index, const PieceOfWork& work, int pipe, pid_t parent) {
  setpgid(0, 0);  // a terminal's signals reach it only through its parent, once
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kStopped);
  stop_signals::install(stop_signals::Messages::kOff);
  int code = kFailed;
  try {
    SendingReporter reporter(pipe);
    code = work(index, reporter) ? kDone : kStopped;
  } catch (const ErrorList& errors) {
    for (const std::string& error : errors.messages()) send(pipe, Kind::kError, error);
  } catch (const std::exception& error) {
    send(pipe, Kind::kError, error.what());
  }
  std::cout.flush();
  _exit(code);  // without what the parent would do at exit
}

struct Process {
  pid_t id = -1;
  int pipe = -1;  ///< -1 once it has ended
  std::string bytes;
  std::optional<std::int64_t> scenes;  ///< how many it makes, once that is known
};

/// @return its status, as from wait(2)
int waitFor(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// All child processes, and what they have sent.
class Processes {
 public:
  explicit Processes(run::Reporter& reporter) : reporter_(reporter) {}
  ~Processes() {
    stop();
    for (Process& process : processes_) {
      if (process.pipe < 0) continue;
      close(process.pipe);  // what it still sends is not read
      waitFor(process.id);
    }
  }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  void start(int index, const PieceOfWork& work) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw Error("cannot make a pipe for a process");
    const pid_t parent = getpid();
    const pid_t id = fork();
    if (id == 0) {
      close(ends[0]);
      runProcess(index, work, ends[1], parent);
    }
    close(ends[1]);
    if (id < 0) {
      close(ends[0]);
      throw Error("cannot start process " + std::to_string(index + 1) + ": " +
                  std::strerror(errno) + "; fewer `processes` may do");
    }
    processes_.push_back({id, ends[0], {}, std::nullopt});
  }

  /// Waits until all have ended. @return whether none was stopped
  bool finish() {
    while (isAnyAlive()) {
      receive();
      if (reporter_.stopRequested()) stop();
    }
    if (!errors_.empty()) throw ErrorList(errors_);
    return !was_stopped_;
  }

 private:
  [[nodiscard]] bool isAnyAlive() const {
    return std::any_of(processes_.begin(), processes_.end(),
                       [](const Process& process) { return process.pipe >= 0; });
  }

  /// Asks all to end after their current scene.
  void stop() {
    if (std::exchange(is_stopping_, true)) return;
    for (const Process& process : processes_) {
      if (process.pipe >= 0) kill(process.id, SIGTERM);
    }
  }

  /// Waits for messages, but not longer than a request to stop may be delayed.
  void receive() {
    constexpr int kPollTimeout = 200;  // [ms]
    std::vector<pollfd> pipes;
    for (const Process& process : processes_) pipes.push_back({process.pipe, POLLIN, 0});
    if (poll(pipes.data(), pipes.size(), kPollTimeout) <= 0) return;
    for (std::size_t i = 0; i < pipes.size(); ++i) {
      if (pipes[i].revents != 0) readFrom(i);
    }
  }

  void readFrom(std::size_t index) {
    Process& process = processes_[index];
    std::array<char, 1U << 16U> buffer{};
    const ssize_t count = read(process.pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
      end(index);
      return;
    }
    process.bytes.append(buffer.data(), static_cast<std::size_t>(count));
    while (const auto message = takeMessage(process.bytes)) take(index, *message);
  }

  void take(std::size_t index, const Message& message) {
    switch (message.kind) {
      case Kind::kInfo:
        if (index == 0) reporter_.info(message.text);
        break;
      case Kind::kWarning:
        if (reported_warnings_.insert(message.text).second) reporter_.warning(message.text);
        break;
      case Kind::kError:
        addError(message.text);
        break;
      case Kind::kStage:
        if (index == 0) reporter_.stage(message.text);
        break;
      case Kind::kScenes:
        processes_[index].scenes = std::stoll(message.text);
        reportScenes();
        break;
      case Kind::kScene:
        ++scenes_made_;
        reportScenes();
        break;
    }
  }

  void addError(const std::string& error) {
    if (std::find(errors_.begin(), errors_.end(), error) == errors_.end()) errors_.push_back(error);
  }

  /// Reports progress once all processes have told how many scenes they make.
  void reportScenes() {
    std::int64_t all = 0;
    for (const Process& process : processes_) {
      if (!process.scenes) return;
      all += *process.scenes;
    }
    if (all == 0) return;
    if (!std::exchange(has_begun_, true)) {
      reporter_.progress(0, all);
      if (isAnyAlive()) return;
    }
    // One at a time: to report all that were made before the counts were known at once would make
    // the run look fast.
    const std::int64_t last =
        isAnyAlive() ? std::min(scenes_reported_ + 1, scenes_made_) : scenes_made_;
    while (scenes_reported_ < last) reporter_.progress(++scenes_reported_, all);
  }

  void end(std::size_t index) {
    Process& process = processes_[index];
    close(std::exchange(process.pipe, -1));
    const int status = waitFor(process.id);
    const bool was_asked =
        WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM;  // before it handled the signal
    if (WIFSIGNALED(status) && !was_asked) {
      addError("process " + std::to_string(index + 1) + " died (" + strsignal(WTERMSIG(status)) +
               "); run the same command again to go on");
    }
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : was_asked ? kStopped : kFailed;
    if (code == kStopped || code > kSignalExitOffset) was_stopped_ = true;
    if (code == kFailed) stop();
    if (!process.scenes) process.scenes = 0;
    reportScenes();
  }

  static constexpr int kSignalExitOffset = 128;  ///< higher exit codes: a signal ended the process

  run::Reporter& reporter_;
  std::vector<Process> processes_;
  std::set<std::string> reported_warnings_;
  std::vector<std::string> errors_;
  std::int64_t scenes_made_ = 0;
  std::int64_t scenes_reported_ = 0;
  bool has_begun_ = false;
  bool is_stopping_ = false;
  bool was_stopped_ = false;
};

/// A process that does a piece of work when it is its turn.
struct Waiting {
  Waiting(int index, const PieceOfWork& work, run::Reporter& reporter) : processes(reporter) {
    processes.start(index, [&](int piece, run::Reporter& of_piece) {
      turn.wait();
      return work(piece, of_piece);
    });
  }

  Turn turn;
  Processes processes;
};

}  // namespace

bool doInProcesses(int count, const PieceOfWork& work, run::Reporter& reporter) {
  Processes processes(reporter);
  for (int index = 0; index < count; ++index) processes.start(index, work);
  return processes.finish();
}

bool doInTurn(int count, const PieceOfWork& work, run::Reporter& reporter) {
  std::vector<std::unique_ptr<Waiting>> all;
  for (int index = 0; index < count; ++index) {
    all.push_back(std::make_unique<Waiting>(index, work, reporter));
  }
  return std::all_of(all.begin(), all.end(), [](const auto& each) {
    each->turn.give();
    return each->processes.finish();
  });
}

}  // namespace synthetic_dataset::programs
