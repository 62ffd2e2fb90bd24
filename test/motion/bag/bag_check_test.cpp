#include "motion/bag/bag_check.h"

#include <cstdint>

#include <gmock/gmock.h>

#include "motion/old_bag.h"
#include "motion/recorded/recorded_camera_info.h"
#include "motion/tf/bag_reader.h"
#include "support/bag_builder.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace bag_check_test {

using test::BagBuilder;
using test::Compression;
using test::milliseconds;
using testing::HasSubstr;

/// Bags with a few bytes changed. librosbag reads beyond its buffers for most of them.
class BagCheck : public testing::Test {
 protected:
  /// The content of a bag with two transforms and a calibration in one chunk.
  [[nodiscard]] std::string bag(Compression compression = Compression::kNone) const {
    return test::readFile(BagBuilder(folder_ / "sound.bag", compression)
                              .move("map", "alpha", milliseconds(1000))
                              .move("map", "alpha", milliseconds(2000))
                              .calibrate("/camera_info", "camera", milliseconds(3000), 100)
                              .close());
  }

  /// The error of reading a bag's transforms and calibration.
  [[nodiscard]] std::string errorOf(const std::string& content) const {
    const std::string file = folder_.write("changed.bag", content).string();
    try {
      readTransforms({file}, [](auto&&...) {});
      static_cast<void>(readCameraInfo({file}, "/camera_info"));
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder_;
};

std::string bytes(std::uint32_t number) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(number >> (8 * i) & 0xFFU);
  return text;
}

/// The content with the 4 bytes at a place replaced by a number.
std::string with(std::string content, std::size_t place, std::uint32_t number) {
  return content.replace(place, 4, bytes(number));
}

/// The place of a field's value in the first record of a kind; ROS writes fields in alphabetical
/// order.
std::size_t valueIn(const std::string& content, char operation, const std::string& field) {
  const std::size_t op = content.find(std::string("op=") + operation);
  const std::size_t place = field < "op" ? content.rfind(field + "=", op) : content.find(field, op);
  return place + field.size() + 1;
}

/// The place of an entry of the first index: seconds, nanoseconds, the message's offset.
std::size_t indexEntry(const std::string& content, std::size_t entry) {
  constexpr std::size_t kVersion = 4;
  constexpr std::size_t kLength = 4;
  return valueIn(content, '\x04', "ver") + kVersion + kLength + 12 * entry;
}

TEST_F(BagCheck, PassesSoundBags) {
  for (const auto compression : {Compression::kNone, Compression::kBz2, Compression::kLz4}) {
    EXPECT_EQ(errorOf(bag(compression)), "no error");
  }
}

TEST_F(BagCheck, RefusesAMessageBeyondItsChunk) {
  const std::string content = bag();
  EXPECT_THAT(errorOf(with(content, indexEntry(content, 0) + 8, 0x00FFFFFF)),
              HasSubstr("beyond the end"));
}

TEST_F(BagCheck, RefusesMessagesInTheSamePlace) {
  const std::string content = bag();
  const std::string first = content.substr(indexEntry(content, 0) + 8, 4);
  std::string changed = content;
  changed.replace(indexEntry(content, 1) + 8, 4, first);
  EXPECT_THAT(errorOf(changed), HasSubstr("messages overlap"));
}

TEST_F(BagCheck, RefusesAnIndexOfAConnectionThatIsNotThere) {
  std::string content = bag();
  content.replace(indexEntry(content, 0), 8, 8, '\0');  // for this time, librosbag logs the topic
  EXPECT_THAT(errorOf(with(content, valueIn(content, '\x04', "conn"), 77)),
              HasSubstr("a connection that does not exist"));
}

TEST_F(BagCheck, RefusesAFieldThatLeavesItsHeader) {
  const std::string content = bag();
  constexpr std::size_t kName = 6;  // "count="
  const std::size_t length = valueIn(content, '\x04', "count") - kName - 4;
  EXPECT_THAT(errorOf(with(content, length, 900000)), HasSubstr("goes beyond its header"));
}

TEST_F(BagCheck, RefusesAHeaderOfGigabytes) {
  const std::string content = bag();
  constexpr std::size_t kFirstLine = 13;
  EXPECT_THAT(errorOf(with(content, kFirstLine, 0xFFFFFFFF)), HasSubstr("too long"));
}

TEST_F(BagCheck, RefusesAnIndexOfMoreEntriesThanTheFileHolds) {
  const std::string content = bag();
  EXPECT_THAT(errorOf(with(content, valueIn(content, '\x04', "count"), 0x7FFFFFFF)),
              HasSubstr("beyond the end"));
}

TEST_F(BagCheck, RefusesAChunkThatIsSaidToGrowBeyondMeasure) {
  const std::string content = bag(Compression::kBz2);
  EXPECT_THAT(errorOf(with(content, valueIn(content, '\x05', "size"), 0x3FFFFFFF)),
              HasSubstr("more than can come from its"));
}

TEST_F(BagCheck, RefusesAChunkThatHasLessInItThanItSays) {
  const std::string content = bag(Compression::kBz2);
  EXPECT_THAT(errorOf(with(content, valueIn(content, '\x05', "size"), 100000)),
              HasSubstr("a chunk holds less than it claims"));
}

TEST_F(BagCheck, RefusesAChunkThatCannotBeDecompressed) {
  std::string content = bag(Compression::kBz2);
  constexpr std::size_t kIntoTheBlock = 20;
  content[content.find("BZh") + kIntoTheBlock] ^= '\x55';
  const std::string file = folder_.write("changed.bag", content).string();
  try {
    checkBag(file, [](const std::string&) { return true; });
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a chunk cannot be decompressed: "));
  }
}

TEST_F(BagCheck, RefusesTransformsThatTheMessageHasNoBytesFor) {
  const std::string content = bag();
  constexpr std::size_t kBefore = 20;  // the count, the sequence number, the stamp, a length
  const std::size_t count = content.find(std::string("map") + bytes(5) + "alpha") - kBefore;
  EXPECT_THAT(errorOf(with(content, count, 0x0FFFFFFF)),
              HasSubstr("its list of transforms is said to have 268435455 entries"));
}

TEST_F(BagCheck, RefusesDistortionThatTheMessageHasNoBytesFor) {
  const std::string content = bag();
  const std::string model = "plumb_bob";
  const std::size_t count = content.find(model + bytes(0)) + model.size();
  EXPECT_THAT(errorOf(with(content, count, 0x0FFFFFFF)),
              HasSubstr("its list of distortion coefficients is said to have"));
}

TEST_F(BagCheck, TellsOfEncryption) {
  const std::string magic = "#ROSBAG V2.0\n";
  const auto sized = [](const std::string& text) {
    return bytes(static_cast<std::uint32_t>(text.size())) + text;
  };
  const std::string header = sized("op=\x03") + sized("encryptor=rosbag/AesCbcEncryptor") +
                             sized("index_pos=" + bytes(13) + bytes(0));
  EXPECT_THAT(errorOf(magic + sized(header) + bytes(0)),
              HasSubstr("is encrypted; `rosbag decrypt`"));
}

TEST_F(BagCheck, RefusesAnOldBagsIndexWithoutATime) {
  std::string content = oldBag("map", "alpha", milliseconds(1000), 1.0);
  EXPECT_EQ(errorOf(content).find("damaged"), std::string::npos);
  constexpr std::size_t kEntry = 16;
  content.replace(content.size() - kEntry, 8, 8, '\0');
  EXPECT_THAT(errorOf(content), HasSubstr("an index has no message with a time"));
}

TEST_F(BagCheck, RefusesAnOldBagsMessageThatIsSaidToBeLong) {
  std::string content = oldBag("map", "alpha", milliseconds(1000), 1.0);
  constexpr std::size_t kName = 4;
  const std::size_t type = content.find("type=", content.find("op=\x02"));
  const std::size_t length = type + std::string("type=tf/tfMessage").size();
  EXPECT_EQ(content.substr(length + kName, 4), "sec=");
  const std::size_t nanoseconds = content.find("nsec=", length) + 5 + 4;
  EXPECT_THAT(errorOf(with(content, nanoseconds, 0x7FFFFFFF)), HasSubstr("beyond the end"));
}

}  // namespace bag_check_test
}  // namespace synthetic_dataset::motion
