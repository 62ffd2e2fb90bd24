#pragma once

namespace synthetic_dataset::programs::stop_signals {

/// Whether a message on stderr says what a signal does.
enum class Messages {
  kOn,
  kOff,  ///< the process from which this one was forked prints them
};

/// SIGPIPE is ignored from now on: a run outlives the reader of its messages. So is SIGXFSZ: a
/// limit of file sizes is reported like a full disk.
void ignoreFailedWriting();

/// From now on SIGINT, SIGTERM and SIGHUP (the terminal has gone) end the process with the exit
/// code 128 + signal and a message on stderr that says how to go on. What the caller of the program
/// ignores, as nohup does SIGHUP, stays ignored. With ignoreFailedWriting.
void install(Messages messages = Messages::kOn);

/// From now on the first of these signals asks for an end, which `requested` answers; a second one
/// ends the process at once.
void waitForScenes();

/// The signal that asked for an end; 0 when none did.
[[nodiscard]] int requested();

/// Its name.
[[nodiscard]] const char* name(int signal);

}  // namespace synthetic_dataset::programs::stop_signals
