#include "render/gl/offscreen_context.h"

#include <pthread.h>

#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace offscreen_context_test {

/// Makes every later thread creation fail for want of room for its stack.
void runOutOfThreads() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, std::size_t{1} << 47U);
  pthread_setattr_default_np(&attributes);
}

[[noreturn]] void makeContextWithoutThreads() {
  runOutOfThreads();
  try {
    const OffscreenContext context;
  } catch (const Error& error) {
    std::cerr << error.what() << '\n';
    std::exit(3);
  }
  std::exit(0);
}

TEST(OffscreenContextDeathTest, TellsThatThereAreNoThreadsRatherThanWaitForThem) {
  testing::FLAGS_gtest_death_test_style =
      "threadsafe";  // in a process that has had no other context
  EXPECT_EXIT(makeContextWithoutThreads(), testing::ExitedWithCode(3),
              "starts no more threads .*: Resource temporarily unavailable; .*ulimit -u");
}

}  // namespace offscreen_context_test
}  // namespace synthetic_dataset::render
