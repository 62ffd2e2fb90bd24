#include "output/writers/writer_loader.h"

#include <gmock/gmock.h>

#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace writer_loader_test {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class WriterLoaderTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::preparePluginEnvironment(); }

  /// The message of the error that making a writer of this type throws.
  static std::string failureOf(const std::vector<std::string>& files, const std::string& type) {
    try {
      WriterLoader loader(files);
      (void)loader.create(type);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(WriterLoaderTest, LoadsThisPackagesWriters) {
  WriterLoader loader({test::pluginXml()});
  for (const char* type :
       {"synthetic_dataset/Yolo", "synthetic_dataset/StvNet", "synthetic_dataset/BoundingShape"}) {
    EXPECT_NE(loader.create(type), nullptr) << type;
  }
}

TEST_F(WriterLoaderTest, FindsWhatPackagesExportWhenNoFilesAreGiven) {
  WriterLoader loader({});
  EXPECT_NE(loader.create("synthetic_dataset/Yolo"), nullptr);
}

TEST_F(WriterLoaderTest, MakesManyWritersOfOneType) {
  WriterLoader loader({test::pluginXml()});
  const auto one = loader.create("synthetic_dataset/Yolo");
  const auto two = loader.create("synthetic_dataset/Yolo");
  EXPECT_NE(one, two);
}

TEST_F(WriterLoaderTest, SuggestsTheTypeThatAMisspeltOneMeans) {
  EXPECT_THAT(failureOf({test::pluginXml()}, "synthetic_dataset/Yollo"),
              AllOf(HasSubstr("no writer type 'synthetic_dataset/Yollo'"),
                    HasSubstr("did you mean 'synthetic_dataset/Yolo'?"),
                    ContainsRegex("available types: .*synthetic_dataset/BoundingShape, .*"
                                  "synthetic_dataset/StvNet, .*synthetic_dataset/Yolo\\)")));
}

TEST_F(WriterLoaderTest, SuggestsThePackageThatWasLeftOut) {
  EXPECT_THAT(failureOf({test::pluginXml()}, "yolo"),
              HasSubstr("did you mean 'synthetic_dataset/Yolo'?"));
}

TEST_F(WriterLoaderTest, SuggestsNothingForATypeLikeNoOther) {
  EXPECT_THAT(failureOf({test::pluginXml()}, "some_vendor/Kitti"), Not(HasSubstr("did you mean")));
}

/// Not all releases of pluginlib name the library; the description does.
TEST_F(WriterLoaderTest, TellsWhereTheLibraryThatIsMissingIsNamed) {
  EXPECT_THAT(
      failureOf({test::testPluginXml()}, "test/NoLibrary"),
      AllOf(HasSubstr("'test/NoLibrary' of package 'synthetic_dataset_test_writers'"),
            HasSubstr("as '" + test::testPluginXml() + "' describes it: "), HasSubstr("library")));
}

TEST_F(WriterLoaderTest, TellsWhichClassIsNotExported) {
  EXPECT_THAT(failureOf({test::testPluginXml()}, "test/NotInLibrary"),
              AllOf(HasSubstr("cannot be loaded"), HasSubstr("NoSuchWriter")));
}

TEST_F(WriterLoaderTest, TellsWhichDescriptionIsMissing) {
  EXPECT_THAT(failureOf({"/no/plugins.xml"}, "test/Misbehaving"), HasSubstr("'/no/plugins.xml'"));
}

TEST_F(WriterLoaderTest, ListsTypesAndWhyOneCannotBeLoaded) {
  const std::vector<WriterType> types = WriterLoader({test::testPluginXml()}).types();
  ASSERT_EQ(types.size(), 3u);
  EXPECT_EQ(types[0].name, "test/Misbehaving");
  EXPECT_EQ(types[0].package, "synthetic_dataset_test_writers");
  EXPECT_EQ(types[0].description, "Does wrong what its parameter asks for.");
  EXPECT_THAT(types[0].problem, IsEmpty());
  EXPECT_THAT(types[1].problem, HasSubstr(test::testPluginXml()));
  EXPECT_THAT(types[2].problem, HasSubstr("NoSuchWriter"));
}

TEST_F(WriterLoaderTest, PrintsNothing) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  (void)WriterLoader({test::testPluginXml(), test::pluginXml()}).types();
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace writer_loader_test
}  // namespace synthetic_dataset::output
