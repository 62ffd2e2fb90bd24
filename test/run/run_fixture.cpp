#include "run_fixture.h"

#include <filesystem>

#include "all_at_once_run.h"
#include "run/generator.h"
#include "support/error_messages.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::test {

RunFixture::RunFixture() { preparePluginEnvironment(); }

run::RunSummary RunFixture::generate() const {
  run::Reporter silent;
  return generate(silent);
}

run::RunSummary RunFixture::generate(run::Reporter& reporter) const {
  run::Generator generator(Value(parameters), reporter, {pluginXml()});
  return generator.run();
}

std::map<std::string, std::string> RunFixture::files() const { return AllAtOnceRun::files(folder); }

std::map<std::string, std::string> RunFixture::filesAnew() const {
  std::filesystem::remove_all(folder);
  (void)generate();
  return files();
}

std::vector<std::string> RunFixture::errors() const {
  return messagesOf([&] {
    run::Reporter silent;
    const run::Generator generator(Value(parameters), silent, {pluginXml()});
  });
}

}  // namespace synthetic_dataset::test
