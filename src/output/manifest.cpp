#include "output/manifest.h"

#include <filesystem>

#include "output/file_name_rules.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

// Without synchronous writes a power cut may cost the last scenes; a killed process costs none. The
// page size is named since SQLite's default has changed once: equal runs make equal bytes.
constexpr const char* kSettings = R"(
  PRAGMA page_size = 4096;
  PRAGMA journal_mode = DELETE;
  PRAGMA synchronous = OFF;
)";

constexpr const char* kTables = R"(
  CREATE TABLE run (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE writer ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
                       output_folder TEXT NOT NULL);
  CREATE TABLE scene ("index" INTEGER PRIMARY KEY, stamp_ns INTEGER NOT NULL,
                      camera TEXT NOT NULL);
  CREATE TABLE file (path TEXT PRIMARY KEY, writer INTEGER NOT NULL, scene INTEGER,
                     bytes INTEGER NOT NULL, linked_to TEXT) WITHOUT ROWID;
  CREATE TABLE record (writer INTEGER NOT NULL, scene INTEGER NOT NULL,
                       sequence INTEGER NOT NULL, text TEXT NOT NULL,
                       PRIMARY KEY (writer, scene, sequence)) WITHOUT ROWID;
)";

SqliteDatabase createDatabase(const std::string& file) {
  SqliteDatabase database(file, SqliteDatabase::Mode::kCreate);
  database.execute(kSettings);
  SqliteTransaction transaction(database);
  database.execute(kTables);
  transaction.commit();
  return database;
}

/// A path as the manifest of this folder lists it.
std::string relativeTo(const std::string& folder, const std::string& path) {
  const std::string below = path.substr(folder.size() + 1);
  return below.empty() ? "./" : below;
}

/// The absolute path that a manifest of this folder lists; a folder's keeps the `/` at its end.
std::string absoluteFrom(const std::string& folder, const std::string& listed) {
  if (!listed.empty() && listed.front() == '/') return listed;
  if (listed == "./" || listed == ".") return folder + "/";
  const bool is_folder = !listed.empty() && listed.back() == '/';
  if (relativePathProblem(is_folder ? listed.substr(0, listed.size() - 1) : listed)) {
    throw Error("'" + manifestFile(folder) + "': it lists the path '" + listed + "'");
  }
  return folder + "/" + listed;
}

std::int64_t signedIndex(std::size_t index) { return static_cast<std::int64_t>(index); }

}  // namespace

std::string manifestFile(const std::string& folder) {
  return (std::filesystem::path(folder) / "manifest.sqlite").string();
}

Manifest::Manifest(const std::string& folder, const std::vector<StoreWriter>& writers)
    : folder_(folder),
      database_(createDatabase(manifestFile(folder))),
      insert_file_(database_, "INSERT INTO file VALUES (?, ?, ?, ?, ?)"),
      find_file_(database_,
                 "SELECT coalesce('scene ' || scene, 'the whole dataset') || ' of writer ''' || "
                 "name || '''' FROM file JOIN writer ON writer.\"index\" = writer WHERE path = ?"),
      delete_file_(database_, "DELETE FROM file WHERE path = ?"),
      insert_scene_(database_, "INSERT INTO scene VALUES (?, ?, ?)"),
      find_scene_(database_, "SELECT 1 FROM scene WHERE \"index\" = ?"),
      insert_record_(database_, "INSERT INTO record VALUES (?, ?, ?, ?)") {
  SqliteTransaction transaction(database_);
  SqliteStatement insert_fact(database_, "INSERT INTO run VALUES (?, ?)");
  insert_fact.run(std::string("format_version"), std::string(kManifestVersion));
  insert_fact.run(std::string("software_version"), std::string(SYNTHETIC_DATASET_VERSION));
  insert_fact.run(std::string("state"), std::string("running"));
  SqliteStatement insert_writer(database_, "INSERT INTO writer VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < writers.size(); ++i) {
    insert_writer.run(signedIndex(i), writers[i].name, writers[i].type,
                      listedPath(writers[i].output_folder));
  }
  transaction.commit();
}

std::string Manifest::listedPath(const std::string& path) const {
  const bool is_below = path.size() > folder_.size() && liesWithin(path, folder_);
  return is_below ? relativeTo(folder_, path) : path;
}

void Manifest::refuseKnown(const ManifestFile& file) {
  const std::string own = manifestFile(folder_);
  if (file.path == own || file.path == own + "-journal") {
    throw Error("'" + file.path + "' is the dataset's manifest; choose another name");
  }
  find_file_.start(listedPath(file.path));
  if (find_file_.step()) {
    const std::string owner = find_file_.text(0);
    find_file_.reset();
    throw Error("'" + file.path + "' belongs to " + owner +
                " already; every file of a dataset should have a name of its own");
  }
  find_file_.reset();
}

void Manifest::announce(std::optional<std::int64_t> scene, const std::vector<ManifestFile>& files) {
  SqliteTransaction transaction(database_);
  if (scene) {
    find_scene_.start(*scene);
    const bool listed = find_scene_.step();
    find_scene_.reset();
    if (listed) throw Error("it is in the dataset already");
  }
  for (const ManifestFile& file : files) {
    refuseKnown(file);
    std::optional<std::string> linked_to;
    if (file.linked_to) linked_to = listedPath(*file.linked_to);
    insert_file_.run(listedPath(file.path), signedIndex(file.writer), scene, file.bytes, linked_to);
  }
  transaction.commit();
}

void Manifest::withdraw(const std::vector<ManifestFile>& files) {
  SqliteTransaction transaction(database_);
  for (const ManifestFile& file : files) delete_file_.run(listedPath(file.path));
  transaction.commit();
}

void Manifest::listScene(std::int64_t index, Stamp stamp, const SceneFiles& scene) {
  SqliteTransaction transaction(database_);
  insert_scene_.run(index, std::int64_t{stamp.count()}, scene.camera);
  std::vector<std::int64_t> sequences;  // by writer
  for (const SceneFiles::Record& record : scene.records) {
    if (record.writer >= sequences.size()) sequences.resize(record.writer + 1, 0);
    insert_record_.run(signedIndex(record.writer), index, sequences[record.writer]++, record.text);
  }
  transaction.commit();
}

bool Manifest::isSceneFile(std::size_t writer, const std::string& path) const {
  SqliteStatement find(database_,
                       "SELECT 1 FROM file WHERE path = ? AND writer = ? AND scene IS NOT NULL");
  find.start(listedPath(path), signedIndex(writer));
  return find.step();
}

void Manifest::setBytes(const std::string& path, std::int64_t bytes) {
  SqliteStatement(database_, "UPDATE file SET bytes = ? WHERE path = ?")
      .run(bytes, listedPath(path));
}

void Manifest::setComplete() {
  database_.execute("UPDATE run SET value = 'complete' WHERE key = 'state'");
}

void Manifest::forEachRecord(
    std::size_t writer, const std::function<void(std::int64_t, const std::string&)>& visit) const {
  SqliteStatement records(
      database_, "SELECT scene, text FROM record WHERE writer = ? ORDER BY scene, sequence");
  records.start(signedIndex(writer));
  while (records.step()) visit(records.integer(0), records.text(1));
}

ManifestContent readManifest(const std::string& folder) {
  const std::string file = manifestFile(folder);
  try {
    const SqliteDatabase database(file, SqliteDatabase::Mode::kExisting);
    const auto forEachRow = [&](const char* sql, const auto& visit) {
      SqliteStatement statement(database, sql);
      while (statement.step()) visit(statement);
    };
    std::string version;
    forEachRow("SELECT value FROM run WHERE key = 'format_version'",
               [&](const SqliteStatement& row) { version = row.text(0); });
    if (version != kManifestVersion) {
      throw Error("'" + file + "': its format version is '" + version + "', not '" +
                  kManifestVersion + "'");
    }
    ManifestContent content;
    forEachRow("SELECT value FROM run WHERE key = 'state'",
               [&](const SqliteStatement& row) { content.complete = row.text(0) == "complete"; });
    forEachRow("SELECT count(*) FROM scene",
               [&](const SqliteStatement& row) { content.scene_count = row.integer(0); });
    forEachRow("SELECT path FROM file", [&](const SqliteStatement& row) {
      content.files.push_back(absoluteFrom(folder, row.text(0)));
    });
    forEachRow("SELECT output_folder FROM writer", [&](const SqliteStatement& row) {
      content.writer_folders.push_back(absoluteFrom(folder, row.text(0)));
    });
    return content;
  } catch (const Error& error) {
    throw Error(std::string("the manifest of an earlier run cannot be read: ") + error.what() +
                "; remove it together with its dataset, or choose another folder");
  }
}

}  // namespace synthetic_dataset::output
