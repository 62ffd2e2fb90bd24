#pragma once

#include <string>
#include <vector>

#include "base/sqlite.h"

namespace synthetic_dataset::output {

/// Rows that break their table's constraints, in a manifest of any version: a line for each
/// constraint, with the first few of its rows. SQLite's own check of a file names the table alone.
[[nodiscard]] std::vector<std::string> brokenRows(const base::SqliteDatabase& database);

/// These, and other rows that no run writes: that point nowhere, have gaps in their numbers or
/// contradict one another.
[[nodiscard]] std::vector<std::string> rowProblems(const base::SqliteDatabase& database);

/// "3, 7, 9 and 12 more": the first few of what a query finds, a column of text; empty for none.
[[nodiscard]] std::string firstRows(const base::SqliteDatabase& database, const std::string& sql);

}  // namespace synthetic_dataset::output
