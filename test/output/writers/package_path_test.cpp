#include "output/writers/package_path.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::output {
namespace package_path_test {

TEST(PackagePath, NamesThePackagesOfInstallSpaces) {
  const test::TemporaryFolder folder;
  (void)folder.write("install/share/zebra/package.xml", "");
  (void)folder.write("install/share/antelope/package.xml", "");
  (void)folder.write("install/share/doc/antelope/README", "");
  (void)folder.write("workspace/src/group/package/package.xml", "");
  const std::string share = folder / "install/share";
  const std::string sources = folder / "workspace/src";
  EXPECT_EQ(withSharedPackages(sources + ":" + share),
            sources + ":" + share + "/antelope:" + share + "/zebra");
}

TEST(PackagePath, LeavesWhatHoldsNoPackages) {
  const test::TemporaryFolder folder;
  (void)folder.write("empty/share/doc/README", "");
  const std::string share = folder / "empty/share";
  EXPECT_EQ(withSharedPackages(share + ":/nowhere/share:/nowhere"),
            share + ":/nowhere/share:/nowhere");
  EXPECT_EQ(withSharedPackages(""), "");
}

}  // namespace package_path_test
}  // namespace synthetic_dataset::output
