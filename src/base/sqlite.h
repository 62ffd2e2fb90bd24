#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace synthetic_dataset::base {

/// What statements need of their database, at a stable address: they stay valid if it is moved.
struct SqliteConnection {
  struct Close {
    void operator()(sqlite3* handle) const;
  };

  /// Throws SQLite's message about its last failure.
  [[noreturn]] void fail() const;

  std::string file;
  std::unique_ptr<sqlite3, Close> handle;
};

/// An open SQLite file; closed when it goes out of scope.
class SqliteDatabase {
 public:
  enum class Mode {
    kCreate,
    kExisting,  ///< with only plain tables
    kReadOnly,
    kForeign,  ///< somebody else's, with only plain tables: no file is changed or made beside it
  };

  /// @throws Error naming the file, also in every other method and in SqliteStatement
  SqliteDatabase(const std::string& file, Mode mode);

  /// Runs statements that have neither parameters nor results.
  void execute(const std::string& sql) const;

  [[noreturn]] void fail() const { connection_->fail(); }

  [[nodiscard]] sqlite3* handle() const { return connection_->handle.get(); }
  [[nodiscard]] const SqliteConnection& connection() const { return *connection_; }

 private:
  /// @throws Error for a file that contains anything else
  void requireTablesOnly() const;
  void open(const std::string& name, int flags);
  void readWhereNobodyCanWrite();
  void openForeign();

  std::unique_ptr<SqliteConnection> connection_;
};

/// Bytes that are not text.
struct Blob {
  std::string bytes;
};

/// A prepared statement. Must not outlive its database, which may be moved.
class SqliteStatement {
 public:
  SqliteStatement(const SqliteDatabase& database, const std::string& sql);

  /// Restarts the statement with these values for its `?`, in order.
  template <class... Values>
  void start(const Values&... values) {
    reset();
    int index = 0;
    (bind(++index, values), ...);
  }

  /// Starts the statement and runs it to the end, for statements without results.
  template <class... Values>
  void run(const Values&... values) {
    start(values...);
    while (step()) {
    }
    reset();
  }

  /// Runs the statement with the values of another statement's current row, from a column on.
  /// @return the constraint that the values violate; nullopt if they were inserted
  [[nodiscard]] std::optional<std::string> runWithRow(const SqliteStatement& row, int first_column);

  /// Advances to the next row of the result.
  /// @returns false if there is none
  bool step();

  void reset();

  // Columns of the current row, from 0.
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] std::string blob(int column) const;
  [[nodiscard]] bool isNull(int column) const;

 private:
  void bind(int index, std::int64_t value);
  void bind(int index, double value);
  void bind(int index, const std::string& value);
  void bind(int index, const Blob& value);
  template <class T>
  void bind(int index, const std::optional<T>& value) {
    if (value) {
      bind(index, *value);
    } else {
      bindNull(index);
    }
  }
  void bindNull(int index);

  struct Finalize {
    void operator()(sqlite3_stmt* handle) const;
  };
  const SqliteConnection* database_;
  std::unique_ptr<sqlite3_stmt, Finalize> handle_;
};

/// The first column of all rows that a query returns.
[[nodiscard]] std::vector<std::string> textsOf(const SqliteDatabase& database,
                                               const std::string& sql);

/// Changes that are made together or, unless committed, not at all.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(const SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  const SqliteDatabase& database_;  ///< must not be moved meanwhile
  bool open_ = true;
};

}  // namespace synthetic_dataset::base
