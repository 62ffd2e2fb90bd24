/// Bags of rosbag2's own tests, whole and cut.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "motion/bag/bag.h"
#include "motion/ros2/bag_folder.h"
#include "reference/reference_folder.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace ros2_bags_test {

namespace fs = std::filesystem;

struct Outcome {
  std::size_t messages = 0;  ///< whose content was read
  std::string refusal;       ///< or the error
};

/// Reads all that can be read.
Outcome outcomeOf(const fs::path& path) {
  Outcome outcome;
  try {
    const auto bag = motion::openBag(path.string());
    const auto messages = bag->messages([](const std::string& /*topic*/) { return true; });
    while (const auto message = messages->next()) {
      if (message->md5sum.empty()) continue;
      (void)message->bytes();
      ++outcome.messages;
    }
  } catch (const Error& error) {
    outcome.refusal = error.what();
  }
  return outcome;
}

/// Folders with files of rosbag2, and these files.
std::set<fs::path> publicBags() {
  std::set<fs::path> bags;
  for (const auto& entry :
       fs::recursive_directory_iterator(test::referenceFolder() / "bags/ros2")) {
    if (motion::hasStorageName(entry.path().string())) {
      bags.insert({entry.path(), entry.path().parent_path()});
    }
  }
  return bags;
}

TEST(Ros2Bags, PublicOnesAreReadOrRefusedWithASentence) {
  std::size_t read = 0;
  for (const fs::path& bag : publicBags()) {
    const Outcome outcome = outcomeOf(bag);
    std::cout << bag.lexically_relative(test::referenceFolder()).string() << ": "
              << (outcome.refusal.empty() ? std::to_string(outcome.messages) + " messages read"
                                          : outcome.refusal)
              << '\n';
    read += outcome.refusal.empty() ? 1 : 0;
  }
  EXPECT_GE(read, 30U);
  const fs::path folder = test::referenceFolder() / "bags/ros2";
  EXPECT_EQ(outcomeOf(folder / "mcap/talker").messages, 10U);
  EXPECT_EQ(outcomeOf(folder / "sqlite3/talker").messages, 10U);
}

TEST(Ros2Bags, CutAnywhereTheyAreReadOrRefused) {
  constexpr int kCuts = 100;
  const test::TemporaryFolder folder;
  std::mt19937_64 random(50);
  std::size_t read = 0;
  std::size_t refused = 0;
  for (const fs::path& bag : publicBags()) {
    if (fs::is_directory(bag)) continue;
    std::ifstream stream(bag, std::ios::binary);
    const std::string content(std::istreambuf_iterator<char>(stream), {});
    for (int i = 0; i < kCuts; ++i) {
      const std::size_t size = random() % content.size();
      const auto cut = folder.write(bag.filename().string(), content.substr(0, size));
      const Outcome outcome = outcomeOf(cut);
      outcome.refusal.empty() ? ++read : ++refused;
    }
  }
  std::cout << read << " cut files were read up to there, " << refused << " refused\n";
  EXPECT_GT(read, 0U);
  EXPECT_GT(refused, 0U);
}

}  // namespace ros2_bags_test
}  // namespace synthetic_dataset
