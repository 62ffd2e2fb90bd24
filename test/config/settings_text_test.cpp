#include "config/settings_text.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::config {
namespace settings_text_test {

using testing::ElementsAre;
using testing::Pair;

TEST(SettingsText, TakesGroupsApartAndPutsThemTogether) {
  const Value tree(Value::Map{
      {"camera", Value(Value::Map{{"far", Value(50.0)}, {"pose", Value(Value::List{Value(1)})}})},
      {"seed", Value(1)}});
  const auto flat = flatSettings(tree);
  EXPECT_THAT(
      flat, ElementsAre(Pair("camera/far", "50.0"), Pair("camera/pose", "[1]"), Pair("seed", "1")));
  EXPECT_EQ(settingsTree(flat), tree);
}

}  // namespace settings_text_test
}  // namespace synthetic_dataset::config
