#pragma once

namespace synthetic_dataset::programs::stop_signals {

/// Whether a message on stderr tells the effect of a signal.
enum class Messages {
  kOn,
  kOff,  ///< the process from which this one was forked prints them
};

/// Ignores SIGPIPE from now on: a run outlives the reader of its messages. Ignores SIGXFSZ, too, so
/// that a limit of file sizes is reported like a full disk.
void ignoreFailedWriting();

/// From now on SIGINT, SIGTERM and SIGHUP (the terminal has gone) end the process with the exit
/// code 128 + signal and a message on stderr that says how to go on. Signals that the program's
/// caller ignores, as nohup does SIGHUP, stay ignored. Calls ignoreFailedWriting.
void install(Messages messages = Messages::kOn);

/// From now on the first of these signals only requests a stop, which `requested` reports; a second
/// one ends the process at once.
void stopAfterScene();

/// The signal that requested a stop; 0 if none did.
[[nodiscard]] int requested();

/// A signal's name, such as "SIGINT".
[[nodiscard]] const char* name(int signal);

}  // namespace synthetic_dataset::programs::stop_signals
