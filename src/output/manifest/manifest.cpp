#include "output/manifest/manifest.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <set>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "output/files/file_system.h"
#include "output/files/pending_file.h"
#include "output/manifest/manifest_paths.h"
#include "output/manifest/raw_numbers.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

/// Sets how durably an open manifest is written. With a write-ahead log, a killed process loses
/// nothing, and a power cut leaves an earlier state intact unless `synchronous` is OFF.
void applySettings(const base::SqliteDatabase& database, const std::string& folder, Sync sync) {
  // A reader may hold a lock on the manifest for a moment.
  database.execute("PRAGMA busy_timeout = 20000");
  // Other processes read the log through shared memory, which machines do not share: on a network
  // file system the run keeps the manifest to itself while it writes.
  if (!isOnLocalDisk(folder)) database.execute("PRAGMA main.locking_mode = EXCLUSIVE");
  database.execute("PRAGMA journal_mode = WAL");
  database.execute(sync == Sync::kOff     ? "PRAGMA synchronous = OFF"
                   : sync == Sync::kBatch ? "PRAGMA synchronous = NORMAL"
                                          : "PRAGMA synchronous = FULL");
}

std::int64_t flag(bool value) { return value ? 1 : 0; }

void insertRun(const base::SqliteDatabase& database, const std::optional<Shard>& shard,
               const RunDescription& run) {
  base::SqliteStatement fact(database, "INSERT INTO run VALUES (?, ?)");
  fact.run(std::string("format_version"), std::string(kManifestVersion));
  fact.run(std::string("scene_count"), std::to_string(run.scene_count));
  fact.run(std::string("settings_digest"), settingsDigest(run));
  fact.run(std::string("global_frame"), run.global_frame);
  if (shard) fact.run(std::string("shard"), shardText(*shard));
  fact.run(std::string("state"), std::string("running"));
  base::SqliteStatement setting(database, "INSERT INTO setting VALUES (?, ?, ?)");
  for (const auto& [name, each] : run.settings) {
    setting.run(name, each.value, flag(each.is_default));
  }
  base::SqliteStatement software(database, "INSERT INTO software VALUES (?, ?)");
  for (const auto& [name, version] : run.software) software.run(name, version);
  base::SqliteStatement input(database, "INSERT INTO input VALUES (?, ?, ?)");
  for (const auto& [path, each] : run.inputs) input.run(path, each.bytes, each.digest);
}

void insertContents(const base::SqliteDatabase& database, const std::string& folder,
                    const std::vector<StoreWriter>& writers, const RunDescription& run) {
  base::SqliteStatement writer(database, "INSERT INTO writer VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < writers.size(); ++i) {
    writer.run(signedIndex(i), writers[i].name, writers[i].type,
               listedPath(folder, writers[i].output_folder));
  }
  base::SqliteStatement one_class(database, "INSERT INTO class VALUES (?, ?)");
  for (const auto& each : run.classes) one_class.run(std::int64_t{each.id}, each.name);
  base::SqliteStatement motion(database, "INSERT INTO motion VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.motions.size(); ++i) {
    const auto& each = run.motions[i];
    motion.run(signedIndex(i), each.name, each.first_instant, each.instant_count);
  }
  base::SqliteStatement camera(database, "INSERT INTO camera VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.cameras.size(); ++i) {
    const auto& each = run.cameras[i];
    camera.run(signedIndex(i), each.name, each.frame, std::int64_t{each.width},
               std::int64_t{each.height});
  }
  base::SqliteStatement object(database, "INSERT INTO object VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < run.objects.size(); ++i) {
    const auto& each = run.objects[i];
    object.run(signedIndex(i), each.name, std::int64_t{each.class_id}, each.id);
  }
}

constexpr std::int64_t kWholeRun = -1;  // the `scene` of a warning that concerns no scene

void insertWarnings(base::SqliteStatement& statement, std::int64_t scene,
                    const std::vector<Warning>& warnings) {
  std::int64_t sequence = 0;
  for (const Warning& warning : warnings) {
    statement.run(scene, sequence++, warning.count, warning.kind, warning.detail);
  }
}

/// Makes a manifest without scenes, at a temporary path.
void fillDatabase(const std::string& file, const std::string& folder,
                  const std::optional<Shard>& shard, const std::vector<StoreWriter>& writers,
                  const RunDescription& run) {
  base::SqliteDatabase database(file, base::SqliteDatabase::Mode::kCreate);
  // Set explicitly, since SQLite has changed its default before: equal runs must make equal bytes.
  database.execute("PRAGMA page_size = 4096");
  database.execute("PRAGMA journal_mode = MEMORY");
  database.execute("PRAGMA synchronous = OFF");
  base::SqliteTransaction transaction(database);
  database.execute(kManifestTables);
  database.execute(kTruthTables);
  insertRun(database, shard, run);
  insertContents(database, folder, writers, run);
  insertTruth(database, run);
  base::SqliteStatement warning(database, "INSERT INTO warning VALUES (?, ?, ?, ?, ?)");
  insertWarnings(warning, kWholeRun, run.warnings);
  transaction.commit();
}

void syncFile(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int failure = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) {
    throw Error("cannot write '" + path + "': " + std::generic_category().message(failure));
  }
}

void giveName(const std::string& temporary, const std::string& file) {
  if (::rename(temporary.c_str(), file.c_str()) != 0) {
    throw Error("cannot write '" + file + "': " + std::generic_category().message(errno));
  }
}

base::SqliteDatabase openDatabase(const std::string& folder, const std::optional<Shard>& shard,
                                  Sync sync) {
  base::SqliteDatabase database(manifestFile(folder, shard), base::SqliteDatabase::Mode::kExisting);
  applySettings(database, folder, sync);
  return database;
}

/// Zeros if there is no such file.
std::pair<std::uint64_t, std::uint64_t> identityOf(const std::string& file) {
  struct stat status = {};
  if (::stat(file.c_str(), &status) != 0) return {};
  return {status.st_dev, status.st_ino};
}

std::optional<double> left(const std::optional<Box>& box) {
  return box ? std::optional(box->left) : std::nullopt;
}
std::optional<double> top(const std::optional<Box>& box) {
  return box ? std::optional(box->top) : std::nullopt;
}
std::optional<double> right(const std::optional<Box>& box) {
  return box ? std::optional(box->right) : std::nullopt;
}
std::optional<double> bottom(const std::optional<Box>& box) {
  return box ? std::optional(box->bottom) : std::nullopt;
}

}  // namespace

Manifest Manifest::create(const std::string& folder, const std::optional<Shard>& shard, Sync sync,
                          const std::vector<StoreWriter>& writers, const RunDescription& run) {
  // Under another name first: even if the run is killed, a manifest has all its tables.
  const std::string file = manifestFile(folder, shard);
  const std::string temporary = temporaryPath(file);
  ::unlink(temporary.c_str());
  try {
    fillDatabase(temporary, folder, shard, writers, run);
    if (sync != Sync::kOff) syncFile(temporary);
    giveName(temporary, file);
    if (sync != Sync::kOff) syncFileSystems({folder});
  } catch (const Error&) {
    ::unlink(temporary.c_str());
    throw;
  }
  return open(folder, shard, sync);
}

Manifest Manifest::open(const std::string& folder, const std::optional<Shard>& shard, Sync sync) {
  return Manifest(folder, shard, openDatabase(folder, shard, sync));
}

Manifest::Manifest(const std::string& folder, const std::optional<Shard>& shard,
                   base::SqliteDatabase database)
    : folder_(folder),
      file_(manifestFile(folder, shard)),
      identity_(identityOf(file_)),
      database_(std::move(database)),
      insert_file_(database_, "INSERT INTO file VALUES (?, ?, ?, ?, ?, ?)"),
      find_file_(database_,
                 "SELECT coalesce('scene ' || scene, 'the whole dataset') || ' of writer ''' || "
                 "name || '''' FROM file JOIN writer ON writer.\"index\" = writer WHERE path = ?"),
      insert_scene_(database_,
                    "INSERT INTO scene VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                    "'begun')"),
      find_scene_(database_, "SELECT 1 FROM scene WHERE \"index\" = ?"),
      set_state_(database_, "UPDATE scene SET state = ? WHERE \"index\" = ?"),
      insert_object_(database_,
                     "INSERT INTO scene_object VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
                     "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)"),
      insert_record_(database_, "INSERT INTO record VALUES (?, ?, ?, ?)"),
      insert_warning_(database_, "INSERT INTO warning VALUES (?, ?, ?, ?, ?)"),
      truth_(database_) {}

std::string Manifest::listedPath(const std::string& path) const {
  return output::listedPath(folder_, path);
}

void Manifest::refuseKnown(const std::string& path) {
  for (const char* own : {"", "-journal", "-wal", "-shm"}) {
    if (path != file_ + own) continue;
    throw Error("'" + path + "' is the dataset's manifest; choose another name");
  }
  find_file_.start(listedPath(path));
  if (find_file_.step()) {
    const std::string owner = find_file_.text(0);
    find_file_.reset();
    throw Error("'" + path + "' belongs to " + owner +
                " already; every file of a dataset should have a name of its own");
  }
  find_file_.reset();
}

void Manifest::insertFile(std::optional<std::int64_t> scene, const ManifestFile& file) {
  refuseKnown(file.path);
  std::optional<std::string> linked_to;
  if (file.linked_to) linked_to = listedPath(*file.linked_to);
  insert_file_.run(listedPath(file.path), signedIndex(file.writer), scene, file.bytes, file.digest,
                   linked_to);
}

void Manifest::announceScene(const SceneFacts& scene, const std::vector<ManifestFile>& files) {
  base::SqliteTransaction transaction(database_);
  find_scene_.start(scene.index);
  const bool listed = find_scene_.step();
  find_scene_.reset();
  if (listed) throw Error("it is in the dataset already");
  const Eigen::Vector3d p = scene.X_GC.translation();
  const Eigen::Quaterniond q(scene.X_GC.linear());
  insert_scene_.run(scene.index, scene.instant, std::int64_t{scene.stamp.count()}, scene.camera,
                    std::int64_t{scene.width}, std::int64_t{scene.height}, scene.split,
                    static_cast<std::int64_t>(scene.seed), p.x(), p.y(), p.z(), q.x(), q.y(), q.z(),
                    q.w());
  for (const ManifestFile& file : files) insertFile(scene.index, file);
  transaction.commit();
}

void Manifest::announce(const ManifestFile& file) {
  base::SqliteTransaction transaction(database_);
  insertFile(std::nullopt, file);
  transaction.commit();
}

void Manifest::withdrawScene(std::int64_t index) {
  base::SqliteTransaction transaction(database_);
  std::vector<std::string> tables = truthTablesOfScenes();
  for (const char* table : {"scene_object", "contact", "draw", "file", "record", "warning"}) {
    tables.emplace_back(table);
  }
  for (const std::string& table : tables) {
    base::SqliteStatement(database_, "DELETE FROM " + table + " WHERE scene = ?").run(index);
  }
  base::SqliteStatement(database_, "DELETE FROM scene WHERE \"index\" = ?").run(index);
  transaction.commit();
}

void Manifest::withdraw(const std::string& path) {
  base::SqliteStatement(database_, "DELETE FROM file WHERE path = ?").run(listedPath(path));
}

void Manifest::insertMeasures(const SceneFacts& scene) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const ObjectFacts& each = scene.objects[i];
    const bool is_in_view = each.loose_box && intersection(*each.loose_box, scene.imageBounds());
    using Number = std::optional<double>;
    const Eigen::Vector3d p = each.X_GO.value_or(Pose::Identity()).translation();
    const Eigen::Quaterniond q(each.X_GO.value_or(Pose::Identity()).linear());
    const auto ifThere = [&](double number) { return each.X_GO ? Number(number) : std::nullopt; };
    insert_object_.run(scene.index, signedIndex(i), ifThere(p.x()), ifThere(p.y()), ifThere(p.z()),
                       ifThere(q.x()), ifThere(q.y()), ifThere(q.z()), ifThere(q.w()),
                       each.distance, flag(is_in_view), left(each.loose_box), top(each.loose_box),
                       right(each.loose_box), bottom(each.loose_box), left(each.silhouette_box),
                       top(each.silhouette_box), right(each.silhouette_box),
                       bottom(each.silhouette_box), left(each.visible_box), top(each.visible_box),
                       right(each.visible_box), bottom(each.visible_box), each.silhouette_pixels,
                       each.visible_pixels, each.visibility, each.truncation, flag(each.dropped),
                       each.mask_agreement);
  }
  base::SqliteStatement contact(database_, "INSERT INTO contact VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const ContactFacts& each = scene.contacts[i];
    contact.run(scene.index, signedIndex(i), each.first, each.second, each.depth);
  }
  base::SqliteStatement draw(database_, "INSERT INTO draw VALUES (?, ?, ?)");
  for (const DrawFacts& each : scene.draws) draw.run(scene.index, each.name, each.value);
  insertWarnings(insert_warning_, scene.index, scene.warnings);
}

void Manifest::listScene(const SceneFacts& scene, const std::vector<PictureFacts>& pictures,
                         const std::vector<SceneFiles::Record>& records) {
  base::SqliteTransaction transaction(database_);
  insertMeasures(scene);
  truth_.insert(scene, pictures);
  std::vector<std::int64_t> sequences;  // by writer
  for (const SceneFiles::Record& record : records) {
    if (record.writer >= sequences.size()) sequences.resize(record.writer + 1, 0);
    insert_record_.run(signedIndex(record.writer), scene.index, sequences[record.writer]++,
                       record.channel + '\n' + record.text);
  }
  set_state_.run(std::string("written"), scene.index);
  transaction.commit();
}

void Manifest::recordSkippedScene(const SceneFacts& scene) {
  announceScene(scene, {});
  base::SqliteTransaction transaction(database_);
  truth_.insertPictureFit(scene);
  insertWarnings(insert_warning_, scene.index, scene.warnings);
  set_state_.run(std::string("left out"), scene.index);
  transaction.commit();
}

void Manifest::markComplete() {
  database_.execute("UPDATE scene SET state = 'complete' WHERE state = 'written'");
}

void Manifest::setContent(const std::string& path, std::int64_t bytes, const std::string& digest) {
  base::SqliteStatement(database_, "UPDATE file SET bytes = ?, digest = ? WHERE path = ?")
      .run(bytes, digest, listedPath(path));
}

bool Manifest::isInPlace() const { return identityOf(file_) == identity_; }

namespace {

/// Retries, because SQLite does not wait for readers here, and there may be some at any time.
void endLog(const base::SqliteDatabase& database) {
  constexpr int kMostTries = 1000;
  constexpr std::chrono::milliseconds kPause(20);
  database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
  for (int tries = 1;; ++tries) {
    try {
      return database.execute("PRAGMA journal_mode = DELETE");
    } catch (const Error&) {
      if (tries == kMostTries) throw;
    }
    std::this_thread::sleep_for(kPause);
  }
}

}  // namespace

void Manifest::reopen() {
  database_.execute("UPDATE run SET value = 'running' WHERE key = 'state'");
  // Each VACUUM increments it; the manifest must end up with the bytes of one finished only once.
  base::SqliteStatement version(database_, "PRAGMA schema_version");
  const std::int64_t counted = version.step() ? version.integer(0) : 0;
  version.reset();
  database_.execute("PRAGMA schema_version = " + std::to_string(counted - 1));
}

void Manifest::listAtEnd(const std::vector<Warning>& warnings) {
  std::set<std::string> listed;
  base::SqliteStatement rows(database_, "SELECT kind FROM warning WHERE scene = ?");
  for (rows.start(kWholeRun); rows.step();) listed.insert(rows.text(0));
  base::SqliteStatement last(database_,
                             "SELECT coalesce(max(sequence), -1) FROM warning WHERE scene = ?");
  last.start(kWholeRun);
  std::int64_t sequence = last.step() ? last.integer(0) : -1;
  last.reset();
  base::SqliteTransaction transaction(database_);
  for (const Warning& each : warnings) {
    if (!listed.insert(each.kind).second) continue;
    insert_warning_.run(kWholeRun, ++sequence, each.count, each.kind, each.detail);
  }
  transaction.commit();
}

void Manifest::finish(const std::vector<Warning>& warnings) {
  listAtEnd(warnings);
  const std::string copy = temporaryPath(file_);
  ::unlink(copy.c_str());
  {
    base::SqliteStatement vacuum(database_, "VACUUM INTO ?");
    vacuum.run(copy);
  }
  {
    // Not in the manifest itself: if killed in between, it would be complete but have other bytes.
    const base::SqliteDatabase rewritten(copy, base::SqliteDatabase::Mode::kExisting);
    rewritten.execute("PRAGMA journal_mode = MEMORY");
    rewritten.execute("UPDATE run SET value = 'complete' WHERE key = 'state'");
  }
  syncFile(copy);
  // The log belongs to the file that is about to be replaced; it would be read with the new one.
  endLog(database_);
  giveName(copy, file_);
}

}  // namespace synthetic_dataset::output
