#include "motion/bag/ros2_bag.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <tuple>
#include <utility>

#include "motion/bag/known_messages.h"
#include "motion/ros2/bag_folder.h"
#include "motion/ros2/cdr.h"
#include "motion/ros2/decompression.h"
#include "motion/ros2/mcap_storage.h"
#include "motion/ros2/sqlite_storage.h"
#include "motion/ros2/storage.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

namespace fs = std::filesystem;

std::string startOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(16, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  return start;
}

bool hasBagInside(const fs::path& folder) {
  if (isFile(folder / "metadata.yaml")) return true;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (hasStorageName(entry->path().string()) && isRos2Bag(entry->path().string())) return true;
  }
  return false;
}

/// Why a topic's messages cannot be read although their type is known; or nothing.
std::string problemOf(const StoredTopic& topic, const KnownMessage& known) {
  if (topic.encoding != "cdr") {
    return "its messages have the encoding '" + topic.encoding + "'; 'cdr' can be read";
  }
  if (topic.definition.empty()) return "";
  try {
    const auto recorded = parseLayout(known.layout->type, topic.definition);
    const std::string difference = differenceOf(*recorded, *known.layout);
    return difference.empty() ? "" : "it is recorded with another definition: " + difference;
  } catch (const Error& error) {
    return error.what();
  }
}

/// A message of the bag; entries are sorted by record time.
struct Entry {
  Stamp recorded{0};
  std::uint64_t number = 0;  ///< of the message, in the order of writing
  std::uint64_t place = 0;   ///< in its file
  std::uint32_t file = 0;
  std::uint32_t topic = 0;
};

/// A message to be returned.
struct Shown {
  std::size_t entry = 0;
  Stamp not_before{0};
};

class Ros2Bag : public Bag {
 public:
  explicit Ros2Bag(const std::string& path) : path_(path) {
    try {
      for (const std::string& file : storageFiles(path)) add(file);
    } catch (const std::exception& error) {
      throw Error("bag " + path_ + ": " + error.what());
    }
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.recorded < b.recorded; });
    if (!entries_.empty()) times_ = {entries_.front().recorded, entries_.back().recorded};
    sortTopics();
  }

  [[nodiscard]] const std::vector<BagTopic>& topics() const override { return sorted_topics_; }

  [[nodiscard]] const std::optional<RecordedTimes>& times() const override { return times_; }

  [[nodiscard]] std::vector<std::string> notes() const override { return notes_; }

  [[nodiscard]] std::string kind() const override {
    const std::string files =
        storages_.size() == 1 ? "" : ", " + std::to_string(storages_.size()) + " files";
    return "ROS 2 (" + storages_.front().kind + files + ")";
  }

  [[nodiscard]] std::unique_ptr<BagMessages> messages(const TopicFilter& is_read,
                                                      std::optional<Stamp> recorded) override;

  [[nodiscard]] BagMessage message(const Shown& shown) const {
    const Entry& entry = entries_[shown.entry];
    const BagTopic& topic = topics_[entry.topic];
    BagMessage message{topic.name, entry.recorded, shown.not_before, entry.number};
    message.md5sum = topic.md5sum;
    message.bytes = [this, &entry] { return bytesOf(entry); };
    return message;
  }

  [[nodiscard]] const Entry& entry(std::size_t index) const { return entries_[index]; }

 private:
  void add(const std::string& file) {
    const std::string within =
        file == path_ ? "" : fs::path(file).filename().string() + " ";  // in the folder
    try {
      storages_.push_back(openStorage(file));
    } catch (const Error& error) {
      throw Error(within + error.what());
    }
    const Storage& storage = storages_.back();
    if (!storage.note.empty()) notes_.push_back("bag " + path_ + ": " + within + storage.note);
    std::vector<std::uint32_t> topic_of;
    for (const StoredTopic& topic : storage.topics) topic_of.push_back(indexOf(topic));
    for (const StoredMessage& each : storage.messages) {
      entries_.push_back({each.recorded, entries_.size(), each.place,
                          static_cast<std::uint32_t>(storages_.size() - 1),
                          topic_of.at(each.topic)});
    }
    storages_.back().messages = {};
    storages_.back().topics = {};
  }

  /// The topic's index in topics_; adds it if it is new.
  std::uint32_t indexOf(const StoredTopic& stored) {
    const std::string type = ros1TypeOf(stored.type);
    const KnownMessage* const known = knownMessage(type);
    BagTopic topic{stored.name, type, ""};
    if (known != nullptr) topic.problem = problemOf(stored, *known);
    if (known != nullptr && topic.problem.empty()) topic.md5sum = known->md5sum;
    const auto same = std::find_if(topics_.begin(), topics_.end(), [&](const BagTopic& each) {
      return std::tie(each.name, each.type, each.problem) ==
             std::tie(topic.name, topic.type, topic.problem);
    });
    if (same != topics_.end()) return static_cast<std::uint32_t>(same - topics_.begin());
    if (!topic.problem.empty()) {
      notes_.push_back("bag " + path_ + ": topic " + topic.name + " (" + type +
                       ") is not read: " + topic.problem);
    }
    topics_.push_back(topic);
    layouts_.push_back(known == nullptr ? nullptr : known->layout);
    return static_cast<std::uint32_t>(topics_.size() - 1);
  }

  /// Only topics that have messages, as a bag of ROS 1 has no others.
  void sortTopics() {
    std::vector<bool> has_messages(topics_.size());
    for (const Entry& each : entries_) has_messages[each.topic] = true;
    for (std::size_t i = 0; i < topics_.size(); ++i) {
      if (has_messages[i]) sorted_topics_.push_back(topics_[i]);
    }
    std::stable_sort(sorted_topics_.begin(), sorted_topics_.end(),
                     [](const BagTopic& a, const BagTopic& b) { return a.name < b.name; });
  }

  [[nodiscard]] std::string bytesOf(const Entry& entry) const {
    std::string bytes = storages_[entry.file].read(entry.place);
    if (isZstd(bytes)) bytes = zstdDecompressed(bytes);  // `--compression-mode message`
    return ros1Serialized(bytes, *layouts_[entry.topic]);
  }

  std::string path_;
  std::vector<Storage> storages_;
  std::vector<BagTopic> topics_;
  std::vector<std::shared_ptr<const MessageLayout>> layouts_;  ///< of topics_; null: not known
  std::vector<BagTopic> sorted_topics_;
  std::vector<Entry> entries_;
  std::optional<RecordedTimes> times_;
  std::vector<std::string> notes_;
};

class Ros2Messages : public BagMessages {
 public:
  Ros2Messages(const Ros2Bag& bag, std::vector<Shown> shown)
      : bag_(bag), shown_(std::move(shown)) {}

  [[nodiscard]] std::optional<Stamp> nextTime() const override {
    if (next_ == shown_.size()) return std::nullopt;
    return bag_.entry(shown_[next_].entry).recorded;
  }

  [[nodiscard]] std::optional<BagMessage> next() override {
    if (next_ == shown_.size()) return std::nullopt;
    return bag_.message(shown_[next_++]);
  }

 private:
  const Ros2Bag& bag_;
  std::vector<Shown> shown_;
  std::size_t next_ = 0;
};

std::unique_ptr<BagMessages> Ros2Bag::messages(const TopicFilter& is_read,
                                               std::optional<Stamp> recorded) {
  std::vector<bool> are_read;
  for (const BagTopic& topic : topics_) are_read.push_back(is_read(topic.name));
  auto begin = entries_.begin();
  auto end = entries_.end();
  if (recorded) {
    const auto before = [](const Entry& entry, Stamp time) { return entry.recorded < time; };
    const auto after = [](Stamp time, const Entry& entry) { return time < entry.recorded; };
    begin = std::lower_bound(begin, end, *recorded, before);
    end = std::upper_bound(begin, end, *recorded, after);
  }
  std::vector<Shown> shown;
  for (auto entry = begin; entry != end; ++entry) {
    if (!are_read[entry->topic]) continue;
    shown.push_back({static_cast<std::size_t>(entry - entries_.begin()), entry->recorded});
  }
  // `not_before` never decreases in the order in which messages were written.
  std::vector<Shown*> written;
  for (Shown& each : shown) written.push_back(&each);
  std::sort(written.begin(), written.end(), [&](const Shown* a, const Shown* b) {
    return entries_[a->entry].number < entries_[b->entry].number;
  });
  Stamp latest{0};
  for (Shown* each : written) latest = each->not_before = std::max(latest, each->not_before);
  return std::make_unique<Ros2Messages>(*this, std::move(shown));
}

}  // namespace

bool isRos2Bag(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return hasBagInside(path);
  if (!isFile(path)) return false;
  const std::string start = startOf(path);
  return isSqlite(start) || isMcap(start) ||
         (isZstd(start) && fs::path(path).extension() == ".zstd");
}

std::vector<std::string> filesOfBag(const std::string& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored) || !isRos2Bag(path)) return {path};
  std::vector<std::string> files = storageFiles(path);
  const std::string metadata = (fs::path(path) / "metadata.yaml").string();
  if (isFile(metadata)) files.push_back(metadata);
  return files;
}

std::unique_ptr<Bag> openRos2Bag(const std::string& path) {
  return std::make_unique<Ros2Bag>(path);
}

}  // namespace synthetic_dataset::motion
