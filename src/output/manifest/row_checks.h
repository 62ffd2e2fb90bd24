#pragma once

#include <string>
#include <vector>

#include "base/sqlite.h"

namespace synthetic_dataset::output {

/// Rows that violate their table's constraints, in a manifest of any version: a line for each
/// constraint, naming the first few rows. SQLite's own check of a file names only the table.
[[nodiscard]] std::vector<std::string> brokenRows(const base::SqliteDatabase& database);

/// Those rows, and others that no run writes: with references that point nowhere, gaps in their
/// numbering, or contradictions.
[[nodiscard]] std::vector<std::string> rowProblems(const base::SqliteDatabase& database);

/// "3, 7, 9 and 12 more": the first few results of a query with one text column; empty if none.
[[nodiscard]] std::string firstRows(const base::SqliteDatabase& database, const std::string& sql);

}  // namespace synthetic_dataset::output
