#include "base/sandbox/sandboxed_program.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::base {
namespace sandboxed_program_test {

using testing::HasSubstr;

ProgramResult resultOf(const std::vector<std::string>& command) {
  return std::get<ProgramResult>(runSandboxedProgram(command, SandboxLimits()));
}

TEST(SandboxedProgram, ReturnsWhatItPrints) {
  const ProgramResult result =
      resultOf({"sh", "-c", "echo \"$1\"; echo oh >&2; exit 3", "sh", "a b"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.output, "a b\n");
  EXPECT_EQ(result.errors, "oh\n");
}

TEST(SandboxedProgram, MayPrintMoreThanAPipeHolds) {
  EXPECT_EQ(resultOf({"sh", "-c", "head -c 3000000 /dev/zero"}).output.size(), 3000000U);
}

TEST(SandboxedProgram, ReadsNoInput) { EXPECT_EQ(resultOf({"cat"}).output, ""); }

TEST(SandboxedProgram, SaysWhenThereIsNone) {
  EXPECT_EQ(resultOf({"no_program_has_this_name"}).exit_code, 127);
}

TEST(SandboxedProgram, IsEndedWhenItDoesNotEnd) {
  SandboxLimits limits;
  limits.processor_time = std::chrono::seconds(1);
  const auto answer = runSandboxedProgram({"sh", "-c", "while :; do :; done"}, limits);
  EXPECT_THAT(std::get<Crash>(answer).how, HasSubstr("does not end within 1 s"));
}

}  // namespace sandboxed_program_test
}  // namespace synthetic_dataset::base
