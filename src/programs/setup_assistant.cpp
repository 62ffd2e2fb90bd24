/// The program `setup_assistant`: serves a page in the browser by which a run is set up.
///
///   rosrun synthetic_dataset setup_assistant [FILE] [BAG...] [--folder DIR]...
///
/// Serves until SIGINT, SIGTERM or SIGHUP; exit code 1 when it cannot start.

#include <pthread.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "base/printable_text.h"
#include "programs/console/command_line.h"
#include "programs/console/heap.h"
#include "programs/console/stop_signals.h"
#include "programs/embedded/embedded_files.h"
#include "programs/setup_assistant/assistant.h"
#include "programs/setup_assistant/start_options.h"
#include "programs/setup_assistant/web/access_check.h"
#include "programs/setup_assistant/web/http_server.h"

namespace {

using namespace synthetic_dataset;

/// Blocks the signals that end the server, before there are threads, so that none is interrupted.
sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

/// An address in the form used in URLs; this machine's name if it means all of its addresses.
std::string hostIn(const std::string& address) {
  if (address == "0.0.0.0" || address == "::") return programs::machineName();
  return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

int serve(const programs::AssistantOptions& options) {
  const sigset_t signals = endingSignals();
  programs::makeSettingsFile(options);
  programs::HttpServer server(options.address, options.port);
  const std::string token = programs::makeToken();
  const programs::AccessCheck access(token, options.address, server.port());
  programs::Assistant assistant(std::filesystem::absolute(options.file).lexically_normal().string(),
                                options.folders, programs::EmbeddedFiles(options.page_folder));
  server.serve([&](const programs::HttpRequest& request) { return access.answer(request); },
               [&](const programs::HttpRequest& request) {
                 return assistant.answer(access.inside(request));
               });
  std::cout << "http://" << hostIn(options.address) << ":" << server.port() << "/?token=" << token
            << std::endl;
  int signal = 0;
  sigwait(&signals, &signal);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second signal ends the process at once
  assistant.close();
  server.stop();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  programs::heap::prepare();
  base::printUtf8();
  programs::AssistantOptions options;
  try {
    options = programs::parseAssistantLine({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "setup_assistant: " << base::printable(error.what()) << '\n'
              << programs::assistantUsage();
    return 1;
  }
  if (options.wants_help) {
    std::cout << programs::assistantUsage();
    return 0;
  }
  programs::stop_signals::ignoreFailedWriting();
  return programs::reportingErrors("setup_assistant", [&] { return serve(options); });
}
