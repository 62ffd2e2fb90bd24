#include "output/manifest/manifest_checks.h"

#include <algorithm>
#include <filesystem>

#include "output/manifest/manifest_schema.h"
#include "output/manifest/row_checks.h"
#include "output/manifest/truth_tables.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

constexpr int kNamed = 3;  // examples named in one line

/// The SQL definitions of a database's tables.
std::vector<std::string> schemaOf(const base::SqliteDatabase& database) {
  return base::textsOf(database,
                       "SELECT type || ' ' || name || ' ' || tbl_name || ' ' || coalesce(sql, '') "
                       "FROM sqlite_master ORDER BY type, name");
}

/// The tables' columns and keys, without other constraints: those of earlier versions differ.
std::vector<std::string> columnsOf(const base::SqliteDatabase& database) {
  return base::textsOf(
      database,
      "SELECT m.type || ' ' || m.name || coalesce(' ' || c.name || ' ' || c.type || ' ' "
      "|| c.pk, '') FROM sqlite_master m LEFT JOIN "
      "pragma_table_info(m.name) c ON m.type = 'table' "
      "WHERE m.name NOT LIKE 'sqlite_autoindex_%' ORDER BY m.type, m.name, c.cid");
}

/// Reports values whose type is not the one declared for the column, or that are infinite: SQLite
/// itself accepts any.
void checkKinds(const base::SqliteDatabase& database, std::vector<std::string>& problems) {
  base::SqliteStatement columns(
      database,
      "SELECT m.name, c.name, lower(c.type) FROM sqlite_master m JOIN pragma_table_info(m.name) c "
      "WHERE m.type = 'table' ORDER BY m.name, c.cid");
  while (columns.step()) {
    const std::string table = columns.text(0);
    const std::string name = columns.text(1);
    const std::string column = "\"" + name + "\"";
    const std::string kind = columns.text(2);
    base::SqliteStatement wrong(database, "SELECT count(*) FROM " + table + " WHERE typeof(" +
                                              column + ") NOT IN ('" + kind +
                                              "', 'null') OR (typeof(" + column +
                                              ") = 'real' AND abs(" + column + ") > 1.7e308)");
    wrong.step();
    if (wrong.integer(0) == 0) continue;
    problems.push_back(table + ": " + std::to_string(wrong.integer(0)) + " values of '" + name +
                       "' are of another kind; they should be " +
                       (kind == "real"   ? "finite numbers"
                        : kind == "text" ? "texts"
                        : kind == "blob" ? "bytes"
                                         : "integers"));
  }
}

std::vector<std::string> findStructureProblems(const base::SqliteDatabase& database) {
  std::vector<std::string> problems;
  base::SqliteStatement findings(database, "PRAGMA quick_check(3)");
  while (findings.step()) {
    const std::string finding = findings.text(0);
    if (finding == "ok" || finding.rfind("CHECK ", 0) == 0) continue;  // rowProblems names the rows
    problems.push_back("it is damaged: " + finding);
  }
  if (!problems.empty()) return problems;
  std::string version;
  {
    base::SqliteStatement row(database, "SELECT value FROM run WHERE key = 'format_version'");
    if (row.step()) version = row.text(0);
  }
  requireKnownVersion(version);
  const base::SqliteDatabase empty(":memory:", base::SqliteDatabase::Mode::kCreate);
  empty.execute(kManifestTables);
  const bool is_current = version == kManifestVersion;
  if (is_current) empty.execute(kTruthTables);
  const auto parts = is_current ? &schemaOf : &columnsOf;
  if (parts(database) != parts(empty)) {
    return {"its tables are not those of version " + version};
  }
  checkKinds(database, problems);
  return problems;
}

/// Checks the run's facts one by one.
void checkRun(const base::SqliteDatabase& database, const std::string& manifest,
              const ManifestContent& content, std::vector<std::string>& problems) {
  std::map<std::string, std::string> facts;
  base::SqliteStatement rows(database, "SELECT key, value FROM run");
  while (rows.step()) facts[rows.text(0)] = rows.text(1);
  const auto check = [&](const std::string& key, const std::string& right) {
    if (facts[key] == right) return;
    problems.push_back("run: found the " + key + " '" + facts[key] + "'; it should be '" + right +
                       "'");
  };
  if (facts["state"] != "running") check("state", "complete");
  check("scene_count", std::to_string(std::max<std::int64_t>(0, content.run.scene_count)));
  check("settings_digest", settingsDigest(content.run));
  const auto shard = shardOfManifest(std::filesystem::path(manifest).filename().string());
  check("shard", shard ? shardText(*shard) : "");
  for (const char* known :
       {"format_version", "state", "scene_count", "settings_digest", "shard", "global_frame"}) {
    facts.erase(known);
  }
  for (const auto& [key, value] : facts)
    problems.push_back("run: found the unknown key '" + key + "'");
}

/// The first few of a sequence of numbers.
class FewNumbers {
 public:
  void add(std::int64_t number) {
    if (++count_ <= kNamed) text_ += (count_ > 1 ? ", " : "") + std::to_string(number);
  }
  [[nodiscard]] bool isEmpty() const { return count_ == 0; }
  [[nodiscard]] bool isFull() const { return count_ > kNamed; }
  [[nodiscard]] std::string text() const { return isFull() ? text_ + " and more" : text_; }

 private:
  std::int64_t count_ = 0;
  std::string text_;
};

/// Checks that the scenes are those of the run or its shard, and all of them if it is complete.
void checkScenes(const base::SqliteDatabase& database, const ManifestContent& content,
                 std::vector<std::string>& problems) {
  const auto cameras =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(content.run.cameras.size()));
  const std::int64_t count = std::max<std::int64_t>(0, content.run.scene_count);
  const auto isOwn = [&](std::int64_t scene) {
    return scene >= 0 && scene < count &&
           (!content.shard || belongsTo(*content.shard, scene / cameras, count / cameras));
  };
  FewNumbers missing;
  FewNumbers foreign;
  std::int64_t next = 0;  // all of the run's own scenes below this index have been seen
  const auto expectUntil = [&](std::int64_t end) {
    for (; next < end && !missing.isFull(); ++next) {
      if (isOwn(next)) missing.add(next);
    }
  };
  base::SqliteStatement rows(
      database, content.complete
                    ? R"(SELECT "index" FROM scene WHERE state <> 'begun' ORDER BY "index")"
                    : R"(SELECT "index" FROM scene ORDER BY "index")");
  while (rows.step()) {
    const std::int64_t scene = rows.integer(0);
    if (!isOwn(scene)) {
      foreign.add(scene);
      continue;
    }
    if (content.complete) expectUntil(scene);
    next = scene + 1;
  }
  if (content.complete) expectUntil(count);
  const std::string whole = content.shard ? "shard " + shardText(*content.shard) + " of " : "";
  if (!missing.isEmpty()) {
    problems.push_back("scene: missing: " + missing.text() + " (of " + whole +
                       std::to_string(count) + ")");
  }
  if (!foreign.isEmpty()) {
    problems.push_back("scene: found " + foreign.text() + "; they do not belong to " + whole +
                       std::to_string(count) + " scenes from 0 on");
  }
  if (!content.complete) return;
  const std::string unsafe = firstRows(
      database,
      "SELECT \"index\" FROM scene WHERE state NOT IN ('complete', 'left out') ORDER BY \"index\"");
  if (!unsafe.empty()) {
    problems.push_back("scene: the run is complete, and these are not: " + unsafe);
  }
}

}  // namespace

std::vector<std::string> structureProblems(const std::string& manifest) {
  try {
    return findStructureProblems(
        base::SqliteDatabase(manifest, base::SqliteDatabase::Mode::kReadOnly));
  } catch (const Error& error) {
    return {"it cannot be read: " + std::string(error.what())};
  }
}

std::vector<std::string> contentProblems(const std::string& manifest,
                                         const ManifestContent& content) {
  const base::SqliteDatabase database(manifest, base::SqliteDatabase::Mode::kReadOnly);
  std::vector<std::string> problems;
  checkRun(database, manifest, content, problems);
  checkScenes(database, content, problems);
  for (std::string& problem : rowProblems(database)) problems.push_back(std::move(problem));
  return problems;
}

}  // namespace synthetic_dataset::output
