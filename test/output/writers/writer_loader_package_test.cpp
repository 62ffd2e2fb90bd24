#include <gtest/gtest.h>

#include "output/writers/writer_loader.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::output {
namespace package_path_test {

const char* const kPackage = "<package/>";

TEST(PackagePath, NamesThePackagesOfInstallSpaces) {
  const test::TemporaryFolder folder;
  (void)folder.write("install/share/zebra/package.xml", kPackage);
  (void)folder.write("install/share/antelope/package.xml", kPackage);
  (void)folder.write("install/share/doc/antelope/README", "");
  (void)folder.write("workspace/src/group/package/package.xml", kPackage);
  const std::string share = folder / "install/share";
  const std::string sources = folder / "workspace/src";
  EXPECT_EQ(soundPackagePath(sources + ":" + share),
            sources + ":" + share + "/antelope:" + share + "/zebra");
}

TEST(PackagePath, LeavesWhatHoldsNoPackages) {
  const test::TemporaryFolder folder;
  (void)folder.write("empty/share/doc/README", "");
  const std::string share = folder / "empty/share";
  EXPECT_EQ(soundPackagePath(share + ":/nowhere/share:/nowhere"),
            share + ":/nowhere/share:/nowhere");
  EXPECT_EQ(soundPackagePath(""), "");
}

TEST(PackagePath, LeavesOutAPackageThatRospackWouldFailAt) {
  const test::TemporaryFolder folder;
  (void)folder.write("src/broken/package.xml", "<package><name>");
  (void)folder.write("src/group/good/package.xml", kPackage);
  (void)folder.write("other/fine/package.xml", kPackage);
  EXPECT_EQ(soundPackagePath((folder / "src").string() + ":" + (folder / "other").string()),
            (folder / "src/group/good").string() + ":" + (folder / "other").string());
}

}  // namespace package_path_test
}  // namespace synthetic_dataset::output
