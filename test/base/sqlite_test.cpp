#include "base/sqlite.h"

#include <cstdint>
#include <memory>
#include <utility>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace sqlite_test {

using testing::HasSubstr;

class Sqlite : public testing::Test {
 protected:
  [[nodiscard]] std::string file() const { return (folder_ / "a.sqlite").string(); }

  void make(const std::string& sql) const {
    SqliteDatabase(file(), SqliteDatabase::Mode::kCreate).execute(sql);
  }
  void open() const { const SqliteDatabase database(file(), SqliteDatabase::Mode::kExisting); }

  test::TemporaryFolder folder_;
};

TEST_F(Sqlite, OpensFilesOfTablesAndIndices) {
  make("CREATE TABLE a (x INTEGER PRIMARY KEY, y TEXT UNIQUE); CREATE INDEX i ON a (y);");
  EXPECT_NO_THROW(open());
}

TEST_F(Sqlite, RefusesAViewThatNeverEnds) {
  make(
      "CREATE VIEW run AS WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x FROM n) "
      "SELECT x AS key, x AS value FROM n;");
  EXPECT_THAT(test::messagesOf([&] { open(); }),
              testing::ElementsAre(HasSubstr("it has 'run', which is not a plain")));
}

TEST_F(Sqlite, RefusesTriggers) {
  make("CREATE TABLE a (x); CREATE TRIGGER t AFTER INSERT ON a BEGIN DELETE FROM a; END;");
  EXPECT_THAT(test::messagesOf([&] { open(); }),
              testing::ElementsAre(HasSubstr("it has 't', which is not a plain")));
}

TEST_F(Sqlite, SaysWhatIsWrongAfterItWasMoved) {
  auto database = std::make_unique<SqliteDatabase>(file(), SqliteDatabase::Mode::kCreate);
  database->execute("CREATE TABLE a (x INTEGER CHECK (x < 10))");
  SqliteStatement insert(*database, "INSERT INTO a VALUES (?)");
  const SqliteDatabase moved = std::move(*database);
  database.reset();
  EXPECT_NO_THROW(insert.run(std::int64_t{1}));
  EXPECT_THAT(test::messagesOf([&] { insert.run(std::int64_t{10}); }),
              testing::ElementsAre(HasSubstr("a.sqlite': CHECK constraint failed")));
}

TEST_F(Sqlite, NamesAFileThatIsNone) {
  static_cast<void>(folder_.write("a.sqlite", std::string(2000, 'x')));
  EXPECT_THAT(test::messagesOf([&] { open(); }),
              testing::ElementsAre(HasSubstr("a.sqlite': file is not a database")));
}

}  // namespace sqlite_test
}  // namespace synthetic_dataset::base
