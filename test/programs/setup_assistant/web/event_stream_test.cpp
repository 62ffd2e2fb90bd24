#include "programs/setup_assistant/web/event_stream.h"

#include <chrono>
#include <memory>

#include <gtest/gtest.h>

namespace synthetic_dataset::programs {
namespace {

constexpr std::chrono::milliseconds kAtOnce(0);

TEST(EventStream, HasTheLastEventOfEachName) {
  EventHub hub;
  const auto stream = hub.subscribe();
  hub.publish("state", "{\"revision\": 1}");
  hub.publish("run", "{}");
  hub.publish("state", "{\"revision\": 2}");
  EXPECT_EQ("event: run\ndata: {}\n\nevent: state\ndata: {\"revision\": 2}\n\n",
            stream->next(kAtOnce).value_or(""));
}

TEST(EventStream, SaysSomethingWhenNothingHappensSoThatPagesThatHaveGoneAreNoticed) {
  EventStream stream;
  EXPECT_EQ(": nothing new\n\n", stream.next(kAtOnce).value_or(""));
}

TEST(EventStream, EndsWhenTheServerDoes) {
  EventHub hub;
  const auto before = hub.subscribe();
  hub.close();
  EXPECT_FALSE(before->next(kAtOnce));
  EXPECT_FALSE(hub.subscribe()->next(kAtOnce));
}

TEST(EventHub, SendsEachPageItsOwn) {
  EventHub hub;
  const auto one = hub.subscribe();
  const auto two = hub.subscribe();
  hub.publish("run", "{}");
  EXPECT_EQ(one->next(kAtOnce), two->next(kAtOnce));
}

}  // namespace
}  // namespace synthetic_dataset::programs
