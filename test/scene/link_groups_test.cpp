#include "scene/link_groups.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::scene {
namespace link_groups_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A floor, a house of a roof and a wall, a lamp that gz-sim labels 7, and an arm of two links,
/// which is an object.
class LinkGroupsTest : public testing::Test {
 protected:
  LinkGroupsTest() {
    for (const char* name : {"body", "roof", "wall", "body", "hand", "finger_1"}) {
      links_.emplace_back();
      links_.back().name = name;
    }
    links_[3].label = 7;
    instances_ = {{&links_[0], world::Role::kStatic, -1, "floor"},
                  {&links_[1], world::Role::kStatic, -1, "house"},
                  {&links_[2], world::Role::kStatic, -1, "house"},
                  {&links_[3], world::Role::kProp, -1, "lamp"},
                  {&links_[4], world::Role::kObject, 1, "arm"},
                  {&links_[5], world::Role::kObject, 1, "arm"}};
  }

  [[nodiscard]] std::vector<std::uint16_t> classesOf(const WorldClasses& classes) {
    return worldClassNumbers(classes, instances_, found_);
  }

  [[nodiscard]] std::vector<std::uint16_t> partsOf(const LinkGroups& parts) {
    std::vector<ObjectOptions> objects(2);
    objects[1].name = "arm";
    objects[1].parts = parts;
    return partNumbers(objects, instances_, found_);
  }

  std::vector<world::Link> links_;
  std::vector<world::LinkInstance> instances_;
  base::Diagnostics found_;
};

TEST_F(LinkGroupsTest, GiveModelsLinksAndLabelsTheirClass) {
  EXPECT_THAT(classesOf({{"ground", {"floor"}}, {"light", {"7"}}, {"wall", {"*::wall"}}}),
              ElementsAre(1, 0, 3, 2, 0, 0));
  EXPECT_THAT(found_.all(), IsEmpty());
}

TEST_F(LinkGroupsTest, GiveObjectsNoClassOfTheWorld) {
  EXPECT_THAT(classesOf({{"everything", {"*"}}}), ElementsAre(1, 1, 1, 1, 0, 0));
}

TEST_F(LinkGroupsTest, RefuseALinkInTwoClasses) {
  (void)classesOf({{"building", {"house"}}, {"wall", {"house::wall"}}});
  EXPECT_THAT(
      found_.messages(base::Severity::kError),
      ElementsAre(HasSubstr("world_classes: 'house::wall' is in 'building' and in 'wall'")));
}

TEST_F(LinkGroupsTest, WarnOfWhatTheWorldHasNot) {
  EXPECT_THAT(classesOf({{"ground", {"flor"}}}), ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_THAT(found_.messages(base::Severity::kWarning),
              ElementsAre(HasSubstr("called or labelled 'flor'; did you mean 'floor'?")));
}

TEST_F(LinkGroupsTest, NumberThePartsOfAnObject) {
  EXPECT_THAT(partsOf({{"fingers", {"finger_*"}}, {"palm", {"hand"}}}),
              ElementsAre(0, 0, 0, 0, 2, 1));
  EXPECT_THAT(found_.all(), IsEmpty());
}

TEST_F(LinkGroupsTest, RefuseLinksThatAnObjectHasNot) {
  (void)partsOf({{"palm", {"hnd"}}});
  EXPECT_THAT(found_.messages(base::Severity::kError),
              ElementsAre(HasSubstr("arm/parts/palm: its model has no link 'hnd'; did you mean "
                                    "'hand'?")));
}

TEST_F(LinkGroupsTest, RefuseALinkInTwoParts) {
  (void)partsOf({{"a", {"hand"}}, {"b", {"*"}}});
  EXPECT_THAT(found_.messages(base::Severity::kError),
              ElementsAre(HasSubstr("arm/parts: the link 'hand' is in 'a' and in 'b'")));
}

}  // namespace link_groups_test
}  // namespace synthetic_dataset::scene
