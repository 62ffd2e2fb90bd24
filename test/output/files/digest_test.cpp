#include "output/files/digest.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace digest_test {

// The examples of FIPS 180-4 and of the empty message.
constexpr const char* kOfNothing =
    "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
constexpr const char* kOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

TEST(Digest, IsThatOfTheStandardsExamples) {
  EXPECT_EQ(digestOf(""), kOfNothing);
  EXPECT_EQ(digestOf("abc"), kOfAbc);
}

TEST(Digest, DoesNotDependOnHowTheBytesCome) {
  Digest digest;
  digest.add("a");
  digest.add("");
  digest.add("bc");
  EXPECT_EQ(digest.text(), kOfAbc);
}

TEST(Digest, OfAFileIsThatOfItsContent) {
  const test::TemporaryFolder folder;
  folder.write("abc", "abc");
  const FileDigest found = digestOfFile((folder / "abc").string());
  EXPECT_EQ(found.bytes, 3);
  EXPECT_EQ(found.digest, kOfAbc);
  EXPECT_EQ(digestOfInput((folder / "abc").string()).digest, kOfAbc);
}

TEST(Digest, NamesAFileThatCannotBeRead) {
  try {
    (void)digestOfFile("/nowhere/at/all");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'/nowhere/at/all': No such file"));
  }
}

}  // namespace digest_test
}  // namespace synthetic_dataset::output
