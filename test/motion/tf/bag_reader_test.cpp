#include "motion/tf/bag_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "motion/old_bag.h"
#include "motion/recorded.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace bag_reader_test {

using test::BagBuilder;
using test::Compression;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class BagReaderTest : public ::testing::Test {
 protected:
  std::string smallBag(const std::string& name) const {
    return BagBuilder(folder / name).move("map", "alpha", milliseconds(1000)).close();
  }

  /// "alpha/tf" of each transform, in the order in which they are visited.
  static std::vector<std::string> read(const std::vector<std::string>& files) {
    std::vector<std::string> seen;
    readTransforms(files, [&](const RecordedTransform& each) {
      seen.push_back(each.transform.child_frame_id +
                     (each.kind == TransformKind::kStatic ? "/tf_static" : "/tf"));
    });
    return seen;
  }

  static std::vector<std::string> errorsOf(const std::vector<std::string>& files) {
    return test::messagesOf([&] { read(files); });
  }

  test::TemporaryFolder folder;
};

TEST_F(BagReaderTest, ReadsBothTopicsWithAndWithoutSlash) {
  BagBuilder bag(folder / "a.bag");
  int ms = 1000;
  for (const std::string topic : {"/tf", "tf_static", "tf", "/tf_static", "/tf_other"}) {
    BagBuilder::Transform transform;
    transform.topic = topic;
    transform.parent = "map";
    transform.child = "of:" + topic;
    transform.recorded = milliseconds(++ms);
    bag.add(transform);
  }
  EXPECT_THAT(read({bag.close()}), ElementsAre("of:/tf/tf", "of:tf_static/tf_static", "of:tf/tf",
                                               "of:/tf_static/tf_static"));
}

TEST_F(BagReaderTest, ReadsEveryCompression) {
  for (const auto compression : {Compression::kNone, Compression::kBz2, Compression::kLz4}) {
    BagBuilder bag(folder / "a.bag", compression);
    bag.splitChunks();
    bag.move("map", "alpha", milliseconds(1000)).move("map", "bravo", milliseconds(1010));
    EXPECT_THAT(read({bag.close()}), ElementsAre("alpha/tf", "bravo/tf"));
  }
}

TEST_F(BagReaderTest, MergesBagsByRecordTime) {
  const std::string first = BagBuilder(folder / "first.bag")
                                .move("map", "a", milliseconds(1000))
                                .move("map", "c", milliseconds(3000))
                                .close();
  const std::string second = BagBuilder(folder / "second.bag")
                                 .move("map", "b", milliseconds(2000))
                                 .move("map", "d", milliseconds(4000))
                                 .close();
  EXPECT_THAT(read({second, first}), ElementsAre("a/tf", "b/tf", "c/tf", "d/tf"));
}

TEST_F(BagReaderTest, TakesItsTimesFromAllTopicsOfAllBags) {
  const std::string talk = BagBuilder(folder / "talk.bag")
                               .say("/chatter", milliseconds(9000))
                               .say("/chatter", milliseconds(500))
                               .close();
  const RecordedTimes times = readTransforms({smallBag("a.bag"), talk}, [](auto&&...) {});
  EXPECT_EQ(times.start, milliseconds(500));
  EXPECT_EQ(times.end, milliseconds(9000));
}

TEST_F(BagReaderTest, ReadsBagsOfVersion12) {
  const auto file = folder.write("old.bag", oldBag("/map", "/alpha", milliseconds(1500), 2.0));
  EXPECT_THAT(read({file.string()}), ElementsAre("/alpha/tf"));
}

TEST_F(BagReaderTest, NamesAllFilesThatCannotBeRead) {
  const std::string missing = folder / "missing.bag";
  const std::string garbage = folder.write("garbage.bag", "GIF89a is a picture");
  const std::string packed = folder.write("packed.bag", "PK\x03\x04 is a zip file");
  const std::string empty = folder.write("empty.bag", "");
  EXPECT_THAT(
      errorsOf({missing, smallBag("good.bag"), garbage, packed, empty, folder.path().string()}),
      ElementsAre(AllOf(HasSubstr(missing), HasSubstr("no such file")),
                  AllOf(HasSubstr(garbage), HasSubstr("is not a bag")),
                  AllOf(HasSubstr(packed), HasSubstr("is compressed; `unzip` unpacks it")),
                  AllOf(HasSubstr(empty), HasSubstr("the file is empty")),
                  AllOf(HasSubstr(folder.path().string()), HasSubstr("is a folder"))));
}

TEST_F(BagReaderTest, AsksForAFile) {
  EXPECT_THAT(errorsOf({}), ElementsAre(HasSubstr("no bag file is named")));
}

TEST_F(BagReaderTest, TellsHowToMendABagThatWasNeverClosed) {
  std::string content = test::readFile(smallBag("a.bag"));
  const std::string field = "index_pos=";
  content.replace(content.find(field) + field.size(), 8, 8, '\0');
  const std::string file = folder.write("recording.bag.active", content);
  EXPECT_THAT(errorsOf({file}),
              ElementsAre(AllOf(HasSubstr("has no index"), HasSubstr("`rosbag reindex " + file))));
}

TEST_F(BagReaderTest, TellsHowToMendATruncatedBagWhereverItEnds) {
  const std::string content = test::readFile(smallBag("a.bag"));
  for (std::size_t size = 13; size < content.size(); size += 41) {
    const std::string file = folder.write("cut.bag", content.substr(0, size));
    EXPECT_THAT(errorsOf({file}), ElementsAre(AllOf(HasSubstr("is truncated or damaged"),
                                                    HasSubstr("`rosbag reindex " + file))))
        << size << " bytes";
  }
}

TEST_F(BagReaderTest, TellsOfAChunkThatCannotBeRead) {
  BagBuilder bag(folder / "a.bag", Compression::kBz2);
  std::string content = test::readFile(bag.move("map", "alpha", milliseconds(1000)).close());
  content.replace(content.find("BZh"), 20, 20, 'x');
  const std::string file = folder.write("broken.bag", content);
  EXPECT_THAT(errorsOf({file, smallBag("good.bag")}),
              ElementsAre(AllOf(HasSubstr(file), HasSubstr("is truncated or damaged"))));
}

TEST_F(BagReaderTest, NamesAVersionThatIsTooOld) {
  EXPECT_THAT(errorsOf({folder.write("a.bag", "#ROSBAG V1.1\n")}),
              ElementsAre(AllOf(HasSubstr("version 1.1"), HasSubstr("2.0 and 1.2 can be read"))));
}

TEST_F(BagReaderTest, NamesATopicOfAnotherType) {
  const std::string file = BagBuilder(folder / "a.bag").say("/tf", milliseconds(1000)).close();
  EXPECT_THAT(errorsOf({file}),
              ElementsAre(AllOf(HasSubstr(file), HasSubstr("topic /tf"),
                                HasSubstr("std_msgs/String"), HasSubstr("tf2_msgs/TFMessage"))));
}

TEST_F(BagReaderTest, TellsWhichTopicsThereAreWhenThereIsNoTf) {
  const std::string talk = BagBuilder(folder / "talk.bag")
                               .say("/chatter", milliseconds(1000))
                               .say("/rosout", milliseconds(1000))
                               .close();
  const std::string silent = BagBuilder(folder / "silent.bag").close();
  EXPECT_THAT(errorsOf({talk, silent}),
              ElementsAre(AllOf(HasSubstr(talk), HasSubstr("no messages of /tf or /tf_static"),
                                HasSubstr("/chatter (std_msgs/String), /rosout (std_msgs/String)")),
                          AllOf(HasSubstr(silent), HasSubstr("has no messages"))));
}

TEST_F(BagReaderTest, AllowsABagWithoutTfBesideOneThatHasSome) {
  const std::string talk = BagBuilder(folder / "talk.bag").say("/chatter", milliseconds(1)).close();
  const std::string silent = BagBuilder(folder / "silent.bag").close();
  EXPECT_THAT(read({talk, silent, smallBag("a.bag")}), ElementsAre("alpha/tf"));
}

}  // namespace bag_reader_test
}  // namespace synthetic_dataset::motion
