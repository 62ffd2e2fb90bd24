#include <filesystem>

#include <gmock/gmock.h>

#include "output/files/file_name_rules.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::output {
namespace file_places_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class FilePlaces : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }

  test::TemporaryFolder folder_;
};

TEST_F(FilePlaces, AreInsideWhetherTheyAreThereOrNot) {
  (void)folder_.write("data/a/0.txt", "");
  EXPECT_THAT(filesOutside({at("data/a/0.txt"), at("data/b/1.txt")}, {at("data")}), IsEmpty());
}

TEST_F(FilePlaces, AreOutsideByTheirPaths) {
  EXPECT_THAT(filesOutside({at("data/0"), at("database/1"), "/etc/passwd"}, {at("data")}),
              ElementsAre(at("database/1"), "/etc/passwd"));
}

TEST_F(FilePlaces, AreOutsideThroughALinkToAFolder) {
  (void)folder_.write("home/precious.txt", "");
  (void)folder_.write("data/0.txt", "");
  fs::create_directory_symlink(at("home"), at("data/images"));
  EXPECT_THAT(filesOutside({at("data/0.txt"), at("data/images/precious.txt")}, {at("data")}),
              ElementsAre(at("data/images/precious.txt")));
}

TEST_F(FilePlaces, AreInsideOfAFolderThatIsReachedThroughALink) {
  (void)folder_.write("disk/data/0.txt", "");
  fs::create_directory_symlink(at("disk"), at("link"));
  EXPECT_THAT(filesOutside({at("link/data/0.txt")}, {at("link/data")}), IsEmpty());
}

}  // namespace file_places_test
}  // namespace synthetic_dataset::output
