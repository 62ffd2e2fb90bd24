#include "output/writers/writer_host.h"
#include "support/error_messages.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace writer_host_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Scene emptyScene() {
  Scene scene(CameraModel(64, 48, {50.0, 50.0, 32.0, 24.0}, 0.05, 100.0));
  scene.name = "00000000";
  scene.camera_name = "camera";
  scene.image = cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(7));
  return scene;
}

class WriterHostTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { test::preparePluginEnvironment(); }

  [[nodiscard]] WriterOptions choice(const std::string& name, Value::Map values,
                                     const std::string& type = "test/Misbehaving") const {
    return {name, type, (folder_ / name).string() + "/", Parameters(std::move(values), name)};
  }

  [[nodiscard]] static WriterHost makeHost(const std::vector<WriterOptions>& choices) {
    return WriterHost(choices, {}, {test::pluginXml(), test::testPluginXml()});
  }

  [[nodiscard]] output::DatasetStore makeStore(const WriterHost& host) const {
    output::StoreOptions options;
    options.folder = folder_.path().string();
    return output::DatasetStore(options, host.storeWriters());
  }

  /// The message of the error that a writer with this fault throws when it is given a scene.
  [[nodiscard]] std::string sceneFailure(const std::string& fault) const {
    const WriterHost host = makeHost({choice("bad", {{"fault", fault}})});
    try {
      (void)host.writeScene(emptyScene());
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  /// The message of the error that a writer with this fault throws when it has to finish.
  [[nodiscard]] std::string finalFailure(const std::string& fault) const {
    const WriterHost host = makeHost({choice("bad", {{"fault", fault}})});
    output::DatasetStore store = makeStore(host);
    try {
      host.finalize(store);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  [[nodiscard]] std::vector<std::string> errorsOf(const std::vector<WriterOptions>& choices) const {
    return test::messagesOf([&] { (void)makeHost(choices); });
  }

  test::TemporaryFolder folder_;
};

TEST_F(WriterHostTest, GathersFilesRecordsAndWarningsOfAllWriters) {
  const WriterHost host = makeHost({choice("a", {}), choice("b", {})});
  const Scene scene = emptyScene();
  const WriterHost::SceneResult result = host.writeScene(scene);
  ASSERT_THAT(result.files.files, SizeIs(4));
  EXPECT_EQ(result.files.files[0].path, (folder_ / "a/same.png").string());
  EXPECT_EQ(result.files.files[0].pixels.data, scene.image.data);
  EXPECT_EQ(result.files.files[3].path, (folder_ / "b/same.txt").string());
  EXPECT_EQ(result.files.files[3].text, "label");
  EXPECT_EQ(result.files.files[3].writer, 1u);
  ASSERT_THAT(result.files.records, SizeIs(2));
  EXPECT_EQ(result.files.records[1].writer, 1u);
  EXPECT_EQ(result.files.records[1].text, "record");
  EXPECT_THAT(result.warnings,
              ElementsAre("writer 'a': alpha: strange", "writer 'b': alpha: strange"));
}

TEST_F(WriterHostTest, NamesAWriterThatEndsTheProgram) {
  // The program is started again for this test only, without the threads and libraries of others.
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  const WriterHost host = makeHost({choice("bad", {{"fault", "exit"}})});
  EXPECT_EXIT((void)host.writeScene(emptyScene()), testing::ExitedWithCode(1),
              "writer 'bad': its plugin has ended the program by calling exit");
}

TEST_F(WriterHostTest, MergesRequirements) {
  const WriterHost host =
      makeHost({choice("a", {{"frames", Value::List{"odom", "base"}}}),
                choice("b", {{"fault", "greedy"}, {"frames", Value::List{"map", "base"}}})});
  EXPECT_TRUE(host.requirements().silhouettes);
  EXPECT_THAT(host.requirements().frames, ElementsAre("base", "map", "odom"));
}

TEST_F(WriterHostTest, AsksForNothingThatNoWriterNeeds) {
  const WriterHost host = makeHost({choice("a", {})});
  EXPECT_FALSE(host.requirements().silhouettes);
  EXPECT_THAT(host.requirements().frames, IsEmpty());
}

TEST_F(WriterHostTest, TellsTheStoreAboutWritersAndTheirUserFiles) {
  const std::string list = (folder_ / "lists/../list.txt").string();
  const auto writers = makeHost({choice("a", {{"list", list}})}).storeWriters();
  ASSERT_THAT(writers, SizeIs(1));
  EXPECT_EQ(writers[0].name, "a");
  EXPECT_EQ(writers[0].type, "test/Misbehaving");
  EXPECT_EQ(writers[0].output_folder, (folder_ / "a/").string());
  EXPECT_THAT(writers[0].user_files, ElementsAre((folder_ / "list.txt").string()));
}

TEST_F(WriterHostTest, TellsAllWritersThatCannotBegin) {
  EXPECT_THAT(errorsOf({choice("a", {}, "test/Misbehavin"), choice("b", {{"fault", "initialize"}}),
                        choice("c", {}, "test/NoLibrary"), choice("d", {})}),
              ElementsAre(AllOf(HasSubstr("writer 'a': there is no writer type 'test/Misbehavin'"),
                                HasSubstr("did you mean 'test/Misbehaving'?")),
                          HasSubstr("writer 'b': there is no calibration"),
                          AllOf(HasSubstr("writer 'c'"), HasSubstr("test/NoLibrary"))));
}

TEST_F(WriterHostTest, NamesTheWriterThatThrows) {
  EXPECT_THAT(sceneFailure("throw"), HasSubstr("writer 'bad': vector::at"));
  EXPECT_THAT(sceneFailure("throw a number"), HasSubstr("writer 'bad'"));
}

TEST_F(WriterHostTest, KeepsWritersInTheirFolders) {
  EXPECT_THAT(sceneFailure("leave the folder"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("'../outside.txt'"), HasSubstr("'..'")));
}

TEST_F(WriterHostTest, RefusesOnePathTwiceInAScene) {
  EXPECT_THAT(sceneFailure("same path twice"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("'same.png' was used twice")));
}

TEST_F(WriterHostTest, AllowsOnePathToTwoWritersAndTwoScenes) {
  const WriterHost host = makeHost({choice("a", {}), choice("b", {})});
  EXPECT_NO_THROW((void)host.writeScene(emptyScene()));
  EXPECT_NO_THROW((void)host.writeScene(emptyScene()));
}

TEST_F(WriterHostTest, RefusesPixelsThatNoImageFileHolds) {
  EXPECT_THAT(sceneFailure("float pixels"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("'0.png'"), HasSubstr("CV_32FC1")));
}

TEST_F(WriterHostTest, RefusesAnUnknownImageFormat) {
  EXPECT_THAT(sceneFailure("other format"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("'0.bmp'"), HasSubstr(".png")));
}

TEST_F(WriterHostTest, FinishesEveryDatasetFromItsRecords) {
  const std::string list = (folder_ / "lists/a.txt").string();
  const WriterHost host =
      makeHost({choice("a", {{"fault", "write the list"}, {"list", list}}), choice("b", {})});
  output::DatasetStore store = makeStore(host);
  store.commitScene({4, Stamp{0}}, {{}, {{0, "all", "of a"}, {1, "all", "of b"}}});
  host.finalize(store);
  EXPECT_EQ(test::readFile(folder_ / "a/all.txt"), "4 of a\n");
  EXPECT_EQ(test::readFile(folder_ / "b/all.txt"), "4 of b\n");
  EXPECT_EQ(test::readFile(list), "4 of a\n");
}

TEST_F(WriterHostTest, RefusesAFileAtAParameterThatWasNotRead) {
  EXPECT_THAT(finalFailure("unknown parameter"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("requiredFile")));
}

TEST_F(WriterHostTest, ChecksPathsOfDatasetFilesToo) {
  EXPECT_THAT(finalFailure("absolute path"),
              AllOf(HasSubstr("writer 'bad'"), HasSubstr("'/etc/list'")));
}

TEST_F(WriterHostTest, RefusesOnePathTwiceForADataset) {
  EXPECT_THAT(finalFailure("same file twice"), HasSubstr("'all.txt' was used twice"));
}

}  // namespace writer_host_test
}  // namespace synthetic_dataset::output
