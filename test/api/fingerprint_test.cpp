#include "synthetic_dataset/fingerprint.h"

#include <gtest/gtest.h>

namespace synthetic_dataset {
namespace fingerprint_test {

// Expected values: the test vectors of the authors' own program (isthe.com/chongo/tech/comp/fnv).

TEST(Fingerprint, BeginsWithTheOffsetBasis) { EXPECT_EQ(Fingerprint().text(), "cbf29ce484222325"); }

TEST(Fingerprint, IsFnv1aOfTheBytesSoFar) {
  Fingerprint fingerprint;
  fingerprint.add("foo", 3);
  fingerprint.add("bar", 3);
  EXPECT_EQ(fingerprint.text(), "85944171f73967e8");
}

}  // namespace fingerprint_test
}  // namespace synthetic_dataset
