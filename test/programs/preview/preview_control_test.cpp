#include "programs/preview/preview_control.h"

#include <atomic>
#include <future>
#include <limits>

#include <gtest/gtest.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace preview_control_test {

using State = PreviewControl::State;

class PreviewControlTest : public ::testing::Test {
 protected:
  /// The next order, which has to exist.
  PreviewControl::Order next() {
    const auto order = control_.awaitOrder();
    EXPECT_TRUE(order);
    return order.value_or(PreviewControl::Order{});
  }

  std::atomic<bool> is_ended_{false};
  PreviewControl control_{[this] { return is_ended_.load(); }, 1000.0};
};

TEST_F(PreviewControlTest, ReadsTheSettingsAndShowsTheFirstInstantAtOnce) {
  EXPECT_EQ(control_.state(), State::kLoading);
  const PreviewControl::Order order = next();
  EXPECT_EQ(order.instant, 0);
  EXPECT_TRUE(order.reads_settings);
  EXPECT_EQ(control_.state(), State::kLoading);
  EXPECT_TRUE(control_.awaitTurn(0));
  EXPECT_EQ(control_.state(), State::kPaused);
}

TEST_F(PreviewControlTest, ShowsAllScenesOfAnInstantTogether) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  EXPECT_TRUE(control_.awaitTurn(0));
}

TEST_F(PreviewControlTest, WaitsForAStepBeforeTheNextInstant) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  auto turn = std::async(std::launch::async, [this] { return control_.awaitTurn(1); });
  EXPECT_EQ(turn.wait_for(std::chrono::seconds(0)), std::future_status::timeout);
  control_.step();
  EXPECT_TRUE(turn.get());
}

TEST_F(PreviewControlTest, PlaysUntilItPauses) {
  next();
  control_.play();
  for (int instant = 0; instant < 5; ++instant) EXPECT_TRUE(control_.awaitTurn(instant));
  EXPECT_EQ(control_.state(), State::kPlaying);
  control_.pause();
  EXPECT_EQ(control_.state(), State::kPaused);
}

TEST_F(PreviewControlTest, LeavesAnOrderForAnother) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  EXPECT_FALSE(control_.isInterrupted());
  auto turn = std::async(std::launch::async, [this] { return control_.awaitTurn(1); });
  control_.jumpTo(40);
  EXPECT_TRUE(control_.isInterrupted());
  EXPECT_FALSE(turn.get());
  const PreviewControl::Order order = next();
  EXPECT_EQ(order.instant, 40);
  EXPECT_FALSE(order.reads_settings);
  EXPECT_TRUE(control_.awaitTurn(40));
}

TEST_F(PreviewControlTest, GoesBackToTheInstantBefore) {
  control_.jumpTo(7);
  EXPECT_TRUE(next().reads_settings) << "a jump before the settings were read";
  EXPECT_TRUE(control_.awaitTurn(7));
  control_.stepBack();
  EXPECT_EQ(next().instant, 6);
  EXPECT_TRUE(control_.awaitTurn(6));
  control_.jumpTo(-3);
  EXPECT_EQ(next().instant, 0);
}

TEST_F(PreviewControlTest, ReloadsAndMakesAgainWhereItIs) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  control_.step();
  EXPECT_TRUE(control_.awaitTurn(1));
  control_.makeAgain();
  const PreviewControl::Order again = next();
  EXPECT_EQ(again.instant, 1);
  EXPECT_FALSE(again.reads_settings);
  control_.reload();
  const PreviewControl::Order reloaded = next();
  EXPECT_EQ(reloaded.instant, 1);
  EXPECT_TRUE(reloaded.reads_settings);
}

TEST_F(PreviewControlTest, PlaysFromTheBeginningAfterTheEnd) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  // All scenes are made, so it asks for another order.
  auto order = std::async(std::launch::async, [this] { return control_.awaitOrder(); });
  while (order.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) control_.play();
  const auto found = order.get();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->instant, 0);
}

TEST_F(PreviewControlTest, EndsWithTheProgram) {
  next();
  EXPECT_TRUE(control_.awaitTurn(0));
  is_ended_ = true;
  EXPECT_FALSE(control_.awaitTurn(1));
  EXPECT_TRUE(control_.isInterrupted());
  EXPECT_FALSE(control_.awaitOrder());
}

TEST_F(PreviewControlTest, RefusesARateThatIsNone) {
  EXPECT_THROW(control_.setRate(0.0), Error);
  EXPECT_THROW(control_.setRate(-1.0), Error);
  EXPECT_THROW(control_.setRate(std::numeric_limits<double>::infinity()), Error);
  EXPECT_NO_THROW(control_.setRate(0.5));
}

}  // namespace preview_control_test
}  // namespace synthetic_dataset::programs
