#include "base/input_file.h"

#include <sys/stat.h>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::base {
namespace input_file_test {

using testing::ElementsAre;

TEST(InputFile, IsRead) {
  const test::TemporaryFolder folder;
  const std::string bytes("a\0b\r\n", 5);
  const auto file = folder.write("file", bytes);
  EXPECT_EQ(readInput(file), bytes);
  EXPECT_EQ(readInputBytes(file).size(), 5U);
  EXPECT_EQ(inputFault(file), "");
}

TEST(InputFile, ThatIsNotThereIsNamed) {
  EXPECT_THAT(test::messagesOf([] { (void)readInput("/no/such/file"); }),
              ElementsAre("/no/such/file: no such file, or it cannot be read"));
  EXPECT_EQ(inputFault("/no/such/file"), "");
}

TEST(InputFile, ThatIsMisspeltIsCalledAsItsNeighbour) {
  const test::TemporaryFolder folder;
  (void)folder.write("husky_real.bag", "");
  (void)folder.write("other.txt", "");
  EXPECT_EQ(didYouMeanFile(folder / "husky_rael.bag"), "; did you mean 'husky_real.bag'?");
  EXPECT_EQ(didYouMeanFile(folder / "something.else"), "");
  EXPECT_EQ(didYouMeanFile(folder / "other.txt"), "") << "it is there";
  EXPECT_EQ(didYouMeanFile("/no/such/folder/file"), "");
}

TEST(InputFile, IsNoFolder) {
  const test::TemporaryFolder folder;
  const std::string name = folder.path().string();
  EXPECT_THAT(test::messagesOf([&] { (void)openInput(name); }),
              ElementsAre(name + ": is a folder; a file is needed"));
}

TEST(InputFile, IsNeitherAPipeNorADevice) {
  const test::TemporaryFolder folder;
  const std::string pipe = (folder / "pipe").string();
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& name : {pipe, std::string("/dev/zero")}) {
    const std::string message = name + ": is a pipe or a device; a file is needed";
    EXPECT_THAT(test::messagesOf([&] { (void)readInput(name); }), ElementsAre(message));
    EXPECT_TRUE(isAboutPipe("mesh '" + message));
  }
  EXPECT_FALSE(isAboutPipe("no such file"));
}

TEST(TextFault, NamesWhatIsNoText) {
  EXPECT_EQ(textFault(""), "");
  EXPECT_EQ(textFault("bag_file: a.bag\n"), "");
  EXPECT_EQ(textFault("\xef\xbb\xbf"
                      "a: 1\n"),
            "")
      << "a mark of UTF-8";
  EXPECT_EQ(textFault("\x1f\x8b\x08"), "is compressed; `gunzip` unpacks it");
  EXPECT_EQ(textFault("BZh91AY"), "is compressed; `bunzip2` unpacks it");
  EXPECT_EQ(textFault("PK\x03\x04"), "is compressed; `unzip` unpacks it");
  EXPECT_EQ(textFault(std::string("\xff\xfe"
                                  "a\0",
                                  4)),
            "is UTF-16; it should be UTF-8, which editors can save");
  EXPECT_EQ(textFault(std::string("\x89PNG\r\n\0\0", 8)), "is not a text file");
  EXPECT_EQ(compressionFault(std::string("\x89PNG\r\n\0\0", 8)), "");
}

}  // namespace input_file_test
}  // namespace synthetic_dataset::base
