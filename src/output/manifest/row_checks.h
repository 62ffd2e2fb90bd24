#pragma once

#include <string>
#include <vector>

#include "output/manifest/sqlite.h"

namespace synthetic_dataset::output {

/// Rows of a manifest that no run writes: that point nowhere, have gaps in their numbers or hold
/// measures that contradict one another. A line for each kind, with the first few of its rows.
[[nodiscard]] std::vector<std::string> rowProblems(const SqliteDatabase& database);

/// "3, 7, 9 and 12 more": the first few of what a query finds, a column of text; empty for none.
[[nodiscard]] std::string firstRows(const SqliteDatabase& database, const std::string& sql);

}  // namespace synthetic_dataset::output
