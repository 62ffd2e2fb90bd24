#include "base/background_worker.h"

#include <pthread.h>

#include <future>
#include <vector>

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace background_worker_test {

TEST(BackgroundWorker, DoesJobsInTheirOrder) {
  std::vector<int> done;
  BackgroundWorker worker(2);
  for (int i = 0; i < 100; ++i) worker.add([&done, i] { done.push_back(i); });
  worker.finish();
  ASSERT_EQ(done.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
}

TEST(BackgroundWorker, WorksWhileTheCallerGoesOn) {
  std::promise<void> caller_went_on;
  bool done = false;
  BackgroundWorker worker(1);
  worker.add([&] {
    caller_went_on.get_future().wait();
    done = true;
  });
  caller_went_on.set_value();  // would never be reached if add() waited for the job
  worker.finish();
  EXPECT_TRUE(done);
}

TEST(BackgroundWorker, GivesWhatAJobThrewToTheCallerAndDoesNoMore) {
  std::promise<void> both_added;
  bool second_done = false;
  BackgroundWorker worker(2);
  worker.add([&] {
    both_added.get_future().wait();
    throw Error("the disk is full");
  });
  worker.add([&] { second_done = true; });
  both_added.set_value();
  EXPECT_THROW(worker.finish(), Error);
  EXPECT_THROW(worker.add([&] { second_done = true; }), Error);
  EXPECT_THROW(worker.finish(), Error);
  EXPECT_FALSE(second_done);
}

/// As long as it exists, no new thread can allocate its stack.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&usual_);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{1} << 47U);
    pthread_setattr_default_np(&attributes);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;
  ~NoMoreThreads() { pthread_setattr_default_np(&usual_); }

 private:
  pthread_attr_t usual_{};
};

TEST(BackgroundWorker, TellsThatTheSystemStartsNoThread) {
  const NoMoreThreads limit;
  try {
    const BackgroundWorker worker(1);
    FAIL() << "a thread was started";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("starts no more threads"));
    EXPECT_THAT(error.what(), testing::HasSubstr("ulimit -u"));
  }
}

}  // namespace background_worker_test
}  // namespace synthetic_dataset::base
