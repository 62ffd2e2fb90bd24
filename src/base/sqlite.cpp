#include "base/sqlite.h"

#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

/// The URI of a file; escapes what would end the path in it. https://www.sqlite.org/uri.html,
/// section 3.1
std::string uriOf(const std::string& file) {
  std::string uri = file.rfind('/', 0) == 0 ? "file://" : "file:";
  for (const char c : file) {
    uri += c == '%' ? "%25" : c == '?' ? "%3f" : c == '#' ? "%23" : std::string(1, c);
  }
  return uri;
}

bool hasContent(const std::string& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  return !error && size > 0;
}

}  // namespace

/// If a statement outlives its database, the connection is closed with the statement.
/// sqlite3_close would leak both. https://www.sqlite.org/c3ref/close.html
void SqliteConnection::Close::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

SqliteDatabase::SqliteDatabase(const std::string& file, Mode mode)
    : connection_(std::make_unique<SqliteConnection>()) {
  connection_->file = file;
  if (mode == Mode::kForeign) {
    openForeign();
    return;
  }
  const int flags = mode == Mode::kReadOnly ? SQLITE_OPEN_READONLY
                    : mode == Mode::kCreate ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE
                                            : SQLITE_OPEN_READWRITE;
  open(file, flags);
  // SQLite opens a file that cannot be written read-only, whatever the flags.
  if (sqlite3_db_readonly(handle(), "main") == 1) readWhereNobodyCanWrite();
  if (mode == Mode::kExisting) requireTablesOnly();
}

void SqliteDatabase::open(const std::string& name, int flags) {
  sqlite3* handle = nullptr;
  const int result = sqlite3_open_v2(name.c_str(), &handle, flags, nullptr);
  connection_->handle.reset(handle);  // set even after a failure, for the message
  if (result != SQLITE_OK) fail();
}

/// To read a database in write-ahead log mode, SQLite needs files beside it, even if the log is
/// empty. On a read-only disk nobody can change the database meanwhile, so that it can be read
/// without them. https://www.sqlite.org/wal.html, section 5
void SqliteDatabase::readWhereNobodyCanWrite() {
  const int result =
      sqlite3_exec(handle(), "SELECT 1 FROM sqlite_master", nullptr, nullptr, nullptr);
  const bool has_log = access((connection_->file + "-wal").c_str(), F_OK) == 0;
  if (result != SQLITE_CANTOPEN || has_log) return;  // other faults are reported where they matter
  open(uriOf(connection_->file) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

/// Reads a write-ahead log beside the file, too, with its index in memory and without locks, as
/// each of these would need a file. https://www.sqlite.org/wal.html, section 8;
/// https://www.sqlite.org/vfs.html
void SqliteDatabase::openForeign() {
  const std::string& file = connection_->file;
  constexpr int kLongest = 1 << 30;  // [byte] of a value
  if (hasContent(file + "-journal")) {
    throw Error("'" + file + "': an unfinished change to it is in " + file +
                "-journal; `sqlite3 FILE .tables` rolls it back");
  }
  const bool has_log = hasContent(file + "-wal");
  open(uriOf(file) + (has_log ? "?vfs=unix-none" : "?immutable=1"),
       SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  sqlite3_limit(handle(), SQLITE_LIMIT_LENGTH, kLongest);
  sqlite3_db_config(handle(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  if (has_log) execute("PRAGMA locking_mode = EXCLUSIVE");
  requireTablesOnly();
}

/// Somebody else's file may contain a never-ending view in place of a table.
/// https://www.sqlite.org/security.html, section 1.2
void SqliteDatabase::requireTablesOnly() const {
  execute("PRAGMA busy_timeout = 20000");  // [ms]: another program may be reading or writing it
  execute("PRAGMA trusted_schema = OFF");
  SqliteStatement others(*this,
                         "SELECT name FROM sqlite_master WHERE type NOT IN ('table', 'index') "
                         "OR sql LIKE 'CREATE VIRTUAL%'");
  if (others.step()) {
    throw Error("'" + connection_->file + "': it has '" + others.text(0) +
                "', which is not a plain table");
  }
}

void SqliteDatabase::execute(const std::string& sql) const {
  if (sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void SqliteConnection::fail() const {
  throw Error("'" + file + "': " + sqlite3_errmsg(handle.get()));
}

void SqliteStatement::Finalize::operator()(sqlite3_stmt* handle) const { sqlite3_finalize(handle); }

SqliteStatement::SqliteStatement(const SqliteDatabase& database, const std::string& sql)
    : database_(&database.connection()) {
  sqlite3_stmt* handle = nullptr;
  const int result = sqlite3_prepare_v2(database.handle(), sql.c_str(),
                                        static_cast<int>(sql.size()), &handle, nullptr);
  handle_.reset(handle);
  if (result != SQLITE_OK) database.fail();
}

std::optional<std::string> SqliteStatement::runWithRow(const SqliteStatement& row,
                                                       int first_column) {
  reset();
  const int count = sqlite3_bind_parameter_count(handle_.get());
  for (int i = 0; i < count; ++i) {
    sqlite3_value* value = sqlite3_column_value(row.handle_.get(), first_column + i);
    if (sqlite3_bind_value(handle_.get(), i + 1, value) != SQLITE_OK) database_->fail();
  }
  const int result = sqlite3_step(handle_.get());
  if (result == SQLITE_DONE) return std::nullopt;
  if (result != SQLITE_CONSTRAINT) database_->fail();
  const std::string broken = sqlite3_errmsg(database_->handle.get());
  const std::string of_check = "CHECK constraint failed: ";  // followed by its name
  return broken.rfind(of_check, 0) == 0 ? broken.substr(of_check.size()) : broken;
}

bool SqliteStatement::step() {
  switch (sqlite3_step(handle_.get())) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
      return false;
    default:
      database_->fail();
  }
}

void SqliteStatement::reset() { sqlite3_reset(handle_.get()); }

std::int64_t SqliteStatement::integer(int column) const {
  return sqlite3_column_int64(handle_.get(), column);
}

double SqliteStatement::real(int column) const {
  return sqlite3_column_double(handle_.get(), column);
}

bool SqliteStatement::isNull(int column) const {
  return sqlite3_column_type(handle_.get(), column) == SQLITE_NULL;
}

std::string SqliteStatement::text(int column) const {
  // The text must be read before its length, as SQLite may convert the value for it.
  const unsigned char* bytes = sqlite3_column_text(handle_.get(), column);
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return bytes == nullptr ? std::string() : std::string(bytes, bytes + size);
}

std::string SqliteStatement::blob(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(handle_.get(), column));
  const int size = sqlite3_column_bytes(handle_.get(), column);
  return bytes == nullptr ? std::string() : std::string(bytes, bytes + size);
}

void SqliteStatement::bind(int index, std::int64_t value) {
  if (sqlite3_bind_int64(handle_.get(), index, value) != SQLITE_OK) database_->fail();
}

void SqliteStatement::bind(int index, double value) {
  if (sqlite3_bind_double(handle_.get(), index, value) != SQLITE_OK) database_->fail();
}

void SqliteStatement::bind(int index, const std::string& value) {
  if (sqlite3_bind_text64(handle_.get(), index, value.data(), value.size(), SQLITE_TRANSIENT,
                          SQLITE_UTF8) != SQLITE_OK) {
    database_->fail();
  }
}

void SqliteStatement::bind(int index, const Blob& value) {
  if (sqlite3_bind_blob64(handle_.get(), index, value.bytes.data(), value.bytes.size(),
                          SQLITE_TRANSIENT) != SQLITE_OK) {
    database_->fail();
  }
}

void SqliteStatement::bindNull(int index) {
  if (sqlite3_bind_null(handle_.get(), index) != SQLITE_OK) database_->fail();
}

std::vector<std::string> textsOf(const SqliteDatabase& database, const std::string& sql) {
  std::vector<std::string> texts;
  SqliteStatement rows(database, sql);
  while (rows.step()) texts.push_back(rows.text(0));
  return texts;
}

SqliteTransaction::SqliteTransaction(const SqliteDatabase& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  // If SQLite cannot roll back now, it will when it next opens the file.
  if (open_) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::commit() {
  database_.execute("COMMIT");
  open_ = false;
}

}  // namespace synthetic_dataset::base
