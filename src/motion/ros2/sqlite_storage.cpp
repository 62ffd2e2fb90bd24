#include "motion/ros2/sqlite_storage.h"

#include <map>
#include <memory>
#include <optional>

#include "base/sqlite.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

using base::SqliteDatabase;
using base::SqliteStatement;

bool hasTable(const SqliteDatabase& database, const std::string& name) {
  SqliteStatement tables(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
  tables.start(name);
  return tables.step();
}

/// The definitions of types, by type.
std::map<std::string, std::string> definitionsIn(const SqliteDatabase& database) {
  std::map<std::string, std::string> definitions;
  if (!hasTable(database, "message_definitions")) return definitions;
  SqliteStatement rows(database,
                       "SELECT topic_type, encoded_message_definition FROM message_definitions "
                       "WHERE encoding = 'ros2msg'");
  while (rows.step()) definitions[rows.text(0)] = rows.text(1);
  return definitions;
}

std::map<std::int64_t, std::uint32_t> readTopics(const SqliteDatabase& database, Storage& storage) {
  const std::map<std::string, std::string> definitions = definitionsIn(database);
  std::map<std::int64_t, std::uint32_t> index_of;  // by the database's id
  SqliteStatement rows(database, "SELECT id, name, type, serialization_format FROM topics");
  while (rows.step()) {
    index_of[rows.integer(0)] = static_cast<std::uint32_t>(storage.topics.size());
    const auto definition = definitions.find(rows.text(2));
    storage.topics.push_back({rows.text(1), rows.text(2), rows.text(3),
                              definition == definitions.end() ? "" : definition->second});
  }
  return index_of;
}

void readMessages(const SqliteDatabase& database, Storage& storage) {
  const std::map<std::int64_t, std::uint32_t> index_of = readTopics(database, storage);
  SqliteStatement rows(database, "SELECT rowid, topic_id, timestamp FROM messages ORDER BY rowid");
  std::optional<std::int64_t> last;
  while (rows.step()) {
    // In a damaged file, pages may lie within one another, so that rows would never end.
    if (last && rows.integer(0) <= *last) throw Error("its messages are not in order");
    last = rows.integer(0);
    const auto topic = index_of.find(rows.integer(1));
    if (topic == index_of.end()) throw Error("a message refers to a topic that does not exist");
    storage.messages.push_back({recordTime(static_cast<std::uint64_t>(rows.integer(2))),
                                topic->second, static_cast<std::uint64_t>(*last)});
  }
}

}  // namespace

bool isSqlite(std::string_view start) {
  using namespace std::string_view_literals;
  return start.substr(0, 16) == "SQLite format 3\0"sv;
}

Storage openSqlite(const std::string& file) {
  const auto database = std::make_shared<SqliteDatabase>(file, SqliteDatabase::Mode::kForeign);
  for (const char* const table : {"topics", "messages"}) {
    if (hasTable(*database, table)) continue;
    throw Error("is an SQLite database without rosbag2's table '" + std::string(table) + "'");
  }
  Storage storage;
  storage.kind = "sqlite3";
  readMessages(*database, storage);
  const auto row =
      std::make_shared<SqliteStatement>(*database, "SELECT data FROM messages WHERE rowid = ?");
  storage.read = [database, row](std::uint64_t place) {
    row->start(static_cast<std::int64_t>(place));
    if (!row->step()) throw Error("it is no longer there");
    return row->blob(0);
  };
  return storage;
}

}  // namespace synthetic_dataset::motion
