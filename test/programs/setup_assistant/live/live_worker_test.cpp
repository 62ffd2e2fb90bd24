#include "programs/setup_assistant/live/live_worker.h"

#include <future>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "programs/setup_assistant/web/http_message.h"
#include "support/tiny_run.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

LiveWorker::Job answering(int value) {
  return [value](run::LiveRun&) { return Value(value); };
}

/// A worker whose thread has a job that ends when it is told to.
struct BusyWorker {
  BusyWorker() {
    first = worker.ask("busy", [this](run::LiveRun&) {
      begun.set_value();
      end.get_future().wait();
      return Value("busy");
    });
    begun.get_future().wait();
  }

  std::promise<void> begun;
  std::promise<void> end;
  LiveWorker worker;
  std::shared_future<Value> first;
};

TEST(LiveWorker, DoesTheLatestRequestOfAKind) {
  BusyWorker busy;
  auto one = busy.worker.ask("scene", answering(1));
  auto other = busy.worker.ask("setup", answering(2));
  auto three = busy.worker.ask("scene", answering(3));
  EXPECT_THROW((void)one.get(), HttpError);  // while the first job goes on
  busy.end.set_value();
  EXPECT_EQ(Value(3), three.get());
  EXPECT_EQ(Value(2), other.get());
  EXPECT_EQ(Value("busy"), busy.first.get());
}

TEST(LiveWorker, AnswersRequestsForTheSameTogether) {
  BusyWorker busy;
  auto one = busy.worker.askOnce("world", answering(1));
  auto other = busy.worker.askOnce("world", answering(2));
  busy.end.set_value();
  EXPECT_EQ(Value(1), one.get());
  EXPECT_EQ(Value(1), other.get());
}

TEST(LiveWorker, PassesOnWhatAJobThrows) {
  LiveWorker worker;
  auto failed = worker.ask("scene", [](run::LiveRun&) -> Value { throw Error("no such camera"); });
  EXPECT_THROW((void)failed.get(), Error);
  EXPECT_EQ(Value(1), worker.ask("scene", answering(1)).get());
}

TEST(LiveWorker, RefusesWhatWaitsAtItsEnd) {
  auto busy = std::make_unique<BusyWorker>();
  auto waiting = busy->worker.ask("scene", answering(1));
  busy->end.set_value();
  auto first = std::move(busy->first);
  busy.reset();
  EXPECT_EQ(Value("busy"), first.get());
  try {
    EXPECT_EQ(Value(1), waiting.get());  // its turn may just have come
  } catch (const HttpError& error) {
    EXPECT_EQ(409, error.status());
  }
}

TEST(LiveWorker, BreaksOffASetUpAndRefusesTheRestWhenItIsClosed) {
  const test::TinyRun tiny;
  std::promise<void> begun;
  std::promise<void> closed;
  LiveWorker worker;
  auto set_up = worker.ask("setup", [&](run::LiveRun& live) {
    begun.set_value();
    closed.get_future().wait();
    live.setSettings(tiny.parameters());
    return Value(live.setup().ready);
  });
  begun.get_future().wait();
  auto waiting = worker.ask("scene", answering(1));
  worker.close();
  EXPECT_THROW((void)waiting.get(), HttpError);  // while the first job goes on
  EXPECT_THROW((void)worker.ask("scene", answering(1)).get(), HttpError);
  closed.set_value();
  EXPECT_THROW((void)set_up.get(), HttpError);
}

}  // namespace
}  // namespace synthetic_dataset::programs
