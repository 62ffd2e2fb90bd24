#include "output/manifest/row_checks.h"

#include <map>
#include <optional>

#include "output/manifest/manifest_schema.h"
#include "output/manifest/truth_tables.h"

namespace synthetic_dataset::output {
namespace {

/// A fault that only shows across several rows, so that a table's constraint cannot express it.
struct Query {
  const char* fault;
  const char* rows;  ///< SQL that yields a text naming each faulty row
};

constexpr Query kQueries[] = {
    {"scene: not as many rows in scene_object as there are objects",
     "SELECT 'scene ' || \"index\" FROM scene s WHERE state IN ('written', 'complete') AND (SELECT "
     "count(*) FROM "
     "scene_object WHERE scene = s.\"index\") <> (SELECT count(*) FROM object)"},
    {"scene: instants that do not follow from index and number of cameras",
     "SELECT 'scene ' || \"index\" FROM scene WHERE instant <> \"index\" / (SELECT max(1, "
     "count(*)) FROM camera)"},
    {"scene: cameras out of turn",
     "SELECT 'scene ' || \"index\" FROM scene s WHERE EXISTS (SELECT 1 FROM camera) AND camera <> "
     "(SELECT name FROM camera c WHERE c.\"index\" = s.\"index\" % (SELECT count(*) FROM camera))"},
    {"scene_object: an in_view that contradicts whether the loose box overlaps the image",
     "SELECT 'scene ' || scene || ' object ' || object FROM scene_object JOIN scene s ON "
     "s.\"index\" = scene WHERE in_view <> coalesce(max(loose_left, -0.5) < min(loose_right, "
     "s.width - 0.5) AND max(loose_top, -0.5) < min(loose_bottom, s.height - 0.5), 0)"},
    {"scene_object: visible boxes that leave the image",
     "SELECT 'scene ' || scene || ' object ' || object FROM scene_object JOIN scene s ON "
     "s.\"index\" = scene WHERE visible_left < -0.5 OR visible_top < -0.5 OR "
     "visible_right > s.width - 0.5 OR visible_bottom > s.height - 0.5"},
    {"scene_object: a distance that is not the one between the poses of object and camera",
     "SELECT 'scene ' || scene || ' object ' || object FROM scene_object m JOIN scene s ON "
     "s.\"index\" = scene WHERE abs((m.x - s.x) * (m.x - s.x) + (m.y - s.y) * (m.y - s.y) + "
     "(m.z - s.z) * (m.z - s.z) - distance * distance) > 1e-6 * (1 + distance * distance)"},
    // Not a constraint: json_valid may come from an extension, which SQLite does not trust when the
    // schema of a file uses it.
    {"draw: values that are not JSON",
     "SELECT 'scene ' || scene || ' ' || name FROM draw WHERE NOT json_valid(value)"},
    {"file: links to anything but a listed file of the same size and digest",
     "SELECT path FROM file f WHERE linked_to NOT NULL AND NOT EXISTS (SELECT 1 FROM file t WHERE "
     "t.path = f.linked_to AND t.bytes = f.bytes AND t.digest = f.digest)"},
    {"file: digests that are missing",  // a file of the whole dataset is listed before it exists
     "SELECT path FROM file WHERE digest = '' AND (scene NOT NULL OR (SELECT value FROM run WHERE "
     "key = 'state') = 'complete')"},
    {"warning: scenes that the table scene does not have",
     "SELECT 'scene ' || scene FROM warning WHERE scene <> -1 AND scene NOT IN (SELECT \"index\" "
     "FROM scene)"},
    {"motion: instants that do not follow those of the motion before",
     "SELECT 'motion ' || \"index\" FROM motion m WHERE first_instant <> (SELECT "
     "coalesce(sum(instant_count), 0) FROM motion WHERE \"index\" < m.\"index\")"},
    {"motion: a total of instants that is not the run's",
     "SELECT value FROM run WHERE key = 'scene_count' AND CAST(value AS INTEGER) <> (SELECT "
     "coalesce(sum(instant_count), 0) FROM motion) * (SELECT max(1, count(*)) FROM camera)"},
};

/// The first few of the rows with a fault.
class FewRows {
 public:
  void add(const std::string& row) {
    if (++count_ <= kNamed) named_ += (named_.empty() ? "" : ", ") + row;
  }
  [[nodiscard]] std::string text() const {
    return count_ > kNamed ? named_ + " and " + std::to_string(count_ - kNamed) + " more" : named_;
  }

 private:
  static constexpr int kNamed = 3;
  std::int64_t count_ = 0;
  std::string named_;
};

std::string joined(const std::vector<std::string>& texts, const std::string& between) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : between) + text;
  return all;
}

/// A table as defined in this version.
struct Table {
  std::string name;
  std::vector<std::string> columns;  ///< in quotes
  std::vector<std::string> key;      ///< columns, in quotes
  std::string row;                   ///< SQL for a text that identifies a row by its key
};

Table describe(const base::SqliteDatabase& tables, const std::string& name) {
  const std::string from = " FROM pragma_table_info('" + name + "') ";
  const std::string of_key = from + "WHERE pk > 0 ORDER BY pk";
  const std::string quoted = R"('"' || name || '"')";
  Table table{name, base::textsOf(tables, "SELECT " + quoted + from + "ORDER BY cid"),
              base::textsOf(tables, "SELECT " + quoted + of_key), ""};
  // "scene 3 object 0", "scene 3", or only a text if it is clear enough.
  if (table.key.size() > 1) {
    const std::string named = R"('''' || name || ' '' || ' || )" + quoted;
    table.row = joined(base::textsOf(tables, "SELECT " + named + of_key), " || ' ' || ");
  } else {
    const bool is_text = base::textsOf(tables, "SELECT type" + of_key)[0] == "TEXT";
    table.row = (is_text ? "" : "'" + name + " ' || ") + table.key[0];
  }
  return table;
}

/// Checks a manifest's rows against the tables of this version.
class RowChecker {
 public:
  explicit RowChecker(const base::SqliteDatabase& database)
      : database_(database), copy_("", base::SqliteDatabase::Mode::kCreate) {  // a temporary file
    copy_.execute("PRAGMA journal_mode = MEMORY");
    copy_.execute("PRAGMA synchronous = OFF");
    copy_.execute(kManifestTables);
    tables_ = describeAll();
    with_constraints_ = tables_;
    const std::vector<std::string> truth =
        base::textsOf(database, "SELECT 1 FROM sqlite_master WHERE name = 'scene_shape'");
    if (!truth.empty()) {
      copy_.execute(kTruthTables);  // large, and without constraints of their own
      tables_ = describeAll();
    }
    copy_.execute("BEGIN");
  }

  /// Finds the rows that cannot be copied into tables with this version's constraints.
  void checkConstraints() {
    for (const Table& table : with_constraints_) {
      const std::vector<std::string> values(table.columns.size(), "?");
      base::SqliteStatement insert(
          copy_, "INSERT INTO " + table.name + " VALUES (" + joined(values, ", ") + ")");
      base::SqliteStatement rows(
          database_,
          "SELECT " + table.row + ", " + joined(table.columns, ", ") + " FROM " + table.name);
      std::map<std::string, FewRows> broken;  // by constraint
      while (rows.step()) {
        if (const auto constraint = insert.runWithRow(rows, 1)) {
          broken[*constraint].add(rows.text(0));
        }
      }
      for (const auto& [constraint, few] : broken) {
        problems_.push_back(table.name + ": " + constraint + ": " + few.text());
      }
    }
  }

  void checkReferences() {
    for (const Table& table : tables_) {
      base::SqliteStatement references(
          copy_,
          "SELECT \"from\", \"table\", \"to\" FROM pragma_foreign_key_list('" + table.name + "')");
      while (references.step()) {
        const std::string column = references.text(0);
        const std::string target = references.text(1);
        check(table.name + ": " + column + (column == "class" ? "es" : "s") + " that the table " +
                  target + " does not have",
              "SELECT " + table.row + " FROM " + table.name + " WHERE " + column +
                  " NOT IN (SELECT \"" + references.text(2) + "\" FROM " + target + ")");
      }
    }
  }

  void checkNumbers() {
    for (const Table& table : tables_) {
      if (table.key.back() == "\"sequence\"") {
        const std::vector<std::string> group(table.key.begin(), table.key.end() - 1);
        check(table.name + ": sequences that do not count from 0",
              "SELECT " + table.row + " FROM " + table.name + " GROUP BY " + joined(group, ", ") +
                  " HAVING min(sequence) <> 0 OR max(sequence) <> count(*) - 1");
      } else if (table.key.back() == "\"index\"" && table.name != "scene") {  // shards have gaps
        check(table.name + ": indices that do not count from 0",
              "SELECT " + table.row + " FROM " + table.name + " t WHERE \"index\" <> (SELECT " +
                  "count(*) FROM " + table.name + " WHERE \"index\" < t.\"index\")");
      }
    }
  }

  void check(const std::string& fault, const std::string& sql) {
    const std::string rows = firstRows(database_, sql);
    if (!rows.empty()) problems_.push_back(fault + ": " + rows);
  }

  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  [[nodiscard]] std::vector<Table> describeAll() const {
    std::vector<Table> tables;
    for (const std::string& name :
         base::textsOf(copy_, "SELECT name FROM sqlite_master WHERE type = 'table'")) {
      tables.push_back(describe(copy_, name));
    }
    return tables;
  }

  const base::SqliteDatabase& database_;
  base::SqliteDatabase copy_;
  std::vector<Table> tables_;
  std::vector<Table> with_constraints_;
  std::vector<std::string> problems_;
};

}  // namespace

std::string firstRows(const base::SqliteDatabase& database, const std::string& sql) {
  FewRows few;
  base::SqliteStatement rows(database, sql);
  while (rows.step()) few.add(rows.text(0));
  return few.text();
}

std::vector<std::string> brokenRows(const base::SqliteDatabase& database) {
  RowChecker checker(database);
  checker.checkConstraints();
  return checker.problems();
}

std::vector<std::string> rowProblems(const base::SqliteDatabase& database) {
  RowChecker checker(database);
  checker.checkConstraints();
  checker.checkReferences();
  checker.checkNumbers();
  for (const Query& each : kQueries) checker.check(each.fault, each.rows);
  return checker.problems();
}

}  // namespace synthetic_dataset::output
