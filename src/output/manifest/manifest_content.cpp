#include "output/manifest/manifest_content.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "base/sqlite.h"
#include "output/manifest/manifest_paths.h"
#include "output/manifest/row_checks.h"
#include "output/manifest/truth_tables.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

constexpr std::int64_t kMostShards = 100000;  // this software never makes more

template <class Visit>
void forEachRow(const base::SqliteDatabase& database, const char* sql, const Visit& visit) {
  base::SqliteStatement statement(database, sql);
  while (statement.step()) visit(statement);
}

std::string versionOf(const base::SqliteDatabase& database) {
  std::string version;
  forEachRow(database, "SELECT value FROM run WHERE key = 'format_version'",
             [&](const base::SqliteStatement& row) { version = row.text(0); });
  return version;
}

bool isCurrent(const base::SqliteDatabase& database) {
  return versionOf(database) == kManifestVersion;
}

void checkWholeness(const base::SqliteDatabase& database) {
  std::string finding;
  forEachRow(database, "PRAGMA quick_check(1)",
             [&](const base::SqliteStatement& row) { finding = row.text(0); });
  if (finding != "ok") {
    for (const std::string& problem : brokenRows(database)) finding += "; " + problem;
    throw Error("it is damaged: " + finding);
  }
  // A missing table is damage, too, even if nothing reads from it now.
  std::vector<std::string> tables = truthTablesOfScenes();
  if (!isCurrent(database)) tables.clear();
  for (const char* table :
       {"run", "setting", "software", "input", "writer", "class", "motion", "camera", "object",
        "scene", "scene_object", "contact", "draw", "file", "record", "warning"}) {
    tables.emplace_back(table);
  }
  for (const std::string& table : tables) {
    const base::SqliteStatement asks(database, "SELECT 1 FROM " + table);
  }
}

void readRun(const base::SqliteDatabase& database, ManifestContent& content) {
  forEachRow(database, "SELECT key, value FROM run", [&](const base::SqliteStatement& row) {
    const std::string key = row.text(0);
    const std::string value = row.text(1);
    if (key == "state") content.complete = value == "complete";
    if (key == "global_frame") content.run.global_frame = value;
    try {
      if (key == "scene_count") content.run.scene_count = std::stoll(value);
      if (key == "shard") {
        const Shard shard{std::stoll(value), std::stoll(value.substr(value.find('/') + 1))};
        if (shard.index < 0 || shard.index >= shard.count || shard.count > kMostShards) {
          throw std::out_of_range(value);
        }
        content.shard = shard;
      }
    } catch (const std::exception&) {
      throw Error("it is damaged: its " + key + " is '" + value + "'");
    }
  });
  forEachRow(database, "SELECT count(*) FROM scene WHERE state IN ('written', 'complete')",
             [&](const base::SqliteStatement& row) { content.scene_count = row.integer(0); });
}

void readDescription(const base::SqliteDatabase& database, RunDescription& run) {
  forEachRow(database, "SELECT name, value, is_default FROM setting",
             [&](const base::SqliteStatement& row) {
               run.settings[row.text(0)] = {row.text(1), row.integer(2) != 0};
             });
  forEachRow(database, "SELECT name, version FROM software",
             [&](const base::SqliteStatement& row) { run.software[row.text(0)] = row.text(1); });
  forEachRow(database, "SELECT path, bytes, digest FROM input",
             [&](const base::SqliteStatement& row) {
               run.inputs[row.text(0)] = {row.integer(1), row.text(2)};
             });
  forEachRow(database, "SELECT id, name FROM class ORDER BY id",
             [&](const base::SqliteStatement& row) {
               run.classes.push_back({static_cast<int>(row.integer(0)), row.text(1)});
             });
  forEachRow(database, "SELECT name, first_instant, instant_count FROM motion ORDER BY \"index\"",
             [&](const base::SqliteStatement& row) {
               run.motions.push_back({row.text(0), row.integer(1), row.integer(2)});
             });
  forEachRow(database, "SELECT name, frame, width, height FROM camera ORDER BY \"index\"",
             [&](const base::SqliteStatement& row) {
               run.cameras.push_back({row.text(0), row.text(1), static_cast<int>(row.integer(2)),
                                      static_cast<int>(row.integer(3))});
             });
  forEachRow(database, "SELECT name, class, id FROM object ORDER BY \"index\"",
             [&](const base::SqliteStatement& row) {
               run.objects.push_back({row.text(0), static_cast<int>(row.integer(1)), row.text(2)});
             });
  forEachRow(database, "SELECT kind, detail, count FROM warning WHERE scene = -1 ORDER BY sequence",
             [&](const base::SqliteStatement& row) {
               run.warnings.push_back({row.text(0), row.text(1), row.integer(2)});
             });
}

std::vector<StoreWriter> readWriters(const base::SqliteDatabase& database,
                                     const std::string& folder) {
  std::vector<StoreWriter> writers;
  forEachRow(database, "SELECT name, type, output_folder FROM writer ORDER BY \"index\"",
             [&](const base::SqliteStatement& row) {
               writers.push_back({row.text(0), row.text(1), absoluteFrom(folder, row.text(2)), {}});
             });
  return writers;
}

/// Checks facts that follow from others or have few possible values.
void checkFacts(const base::SqliteDatabase& database, const RunDescription& run) {
  std::map<std::string, std::string> facts;
  forEachRow(database, "SELECT key, value FROM run",
             [&](const base::SqliteStatement& row) { facts[row.text(0)] = row.text(1); });
  if (facts["state"] != "running" && facts["state"] != "complete") {
    throw Error("it is damaged: its state is '" + facts["state"] + "'");
  }
  if (facts["settings_digest"] != settingsDigest(run)) {
    throw Error("it is damaged: its settings are not those of its settings_digest");
  }
}

}  // namespace

ManifestContent readWithoutFiles(const base::SqliteDatabase& database, const std::string& folder) {
  ManifestContent content;
  readRun(database, content);
  readDescription(database, content.run);
  content.is_current = isCurrent(database);
  if (content.is_current) readTruth(database, content.run);
  content.writers = readWriters(database, folder);
  return content;
}

ManifestContent readManifest(const std::string& file, ManifestFiles files) {
  const std::string folder = std::filesystem::path(file).parent_path().string();
  try {
    const base::SqliteDatabase database(file, base::SqliteDatabase::Mode::kExisting);
    database.execute("PRAGMA busy_timeout = 20000");
    requireKnownVersion(versionOf(database));
    if (files == ManifestFiles::kRead) checkWholeness(database);
    ManifestContent content = readWithoutFiles(database, folder);
    checkFacts(database, content.run);
    if (files == ManifestFiles::kLeftOut) return content;
    forEachRow(database, "SELECT path FROM file", [&](const base::SqliteStatement& row) {
      content.files.push_back(absoluteFrom(folder, row.text(0)));
    });
    return content;
  } catch (const Error& error) {
    throw Error("the manifest '" + file + "' of an earlier run cannot be read: " + error.what() +
                "; remove it together with its dataset, or choose another folder");
  }
}

std::vector<std::string> shardManifests(const std::string& folder) {
  std::vector<std::string> manifests;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (shardOfManifest(entry->path().filename().string())) {
      manifests.push_back(entry->path().string());
    }
  }
  std::sort(manifests.begin(), manifests.end());
  return manifests;
}

}  // namespace synthetic_dataset::output
