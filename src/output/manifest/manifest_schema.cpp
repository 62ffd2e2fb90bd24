#include "output/manifest/manifest_schema.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {

std::string shardText(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count) {
  constexpr std::int64_t kLongestBlock = 64;  // instants
  constexpr std::int64_t kBlocksOfEach = 4;   // per shard, at least, if there are enough instants
  const std::int64_t block =
      std::clamp<std::int64_t>(instant_count / (shard.count * kBlocksOfEach), 1, kLongestBlock);
  return instant / block % shard.count == shard.index;
}

// References are checked when a manifest is verified, not while it is written, because a shard's
// tables are copied one after another. Constraints that recompute a value may do so in another
// order than the run did, so they allow for a difference in the last bits.
const char* const kManifestTables = R"sql(
  CREATE TABLE run (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE setting (name TEXT PRIMARY KEY, value TEXT NOT NULL,
                        is_default INTEGER NOT NULL) WITHOUT ROWID;
  CREATE TABLE software (name TEXT PRIMARY KEY, version TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE input (path TEXT PRIMARY KEY, bytes INTEGER NOT NULL,
                      digest TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE writer ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, type TEXT NOT NULL,
                       output_folder TEXT NOT NULL);
  CREATE TABLE class (id INTEGER PRIMARY KEY, name TEXT NOT NULL,
    CONSTRAINT "ids that are no numbers of classes" CHECK (id BETWEEN 0 AND 2147483647));
  CREATE TABLE motion ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
                       first_instant INTEGER NOT NULL, instant_count INTEGER NOT NULL,
    CONSTRAINT "no instants" CHECK (instant_count >= 1));
  CREATE TABLE camera ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, frame TEXT NOT NULL,
                       width INTEGER NOT NULL, height INTEGER NOT NULL,
    CONSTRAINT "sizes that no image has"
      CHECK (width BETWEEN 1 AND 1000000 AND height BETWEEN 1 AND 1000000));
  CREATE TABLE object ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE,
                       class INTEGER NOT NULL REFERENCES class (id), id TEXT NOT NULL);
  CREATE TABLE scene ("index" INTEGER PRIMARY KEY, instant INTEGER NOT NULL,
                      stamp_ns INTEGER NOT NULL, camera TEXT NOT NULL REFERENCES camera (name),
                      width INTEGER NOT NULL, height INTEGER NOT NULL, split TEXT NOT NULL,
                      seed INTEGER NOT NULL, x REAL, y REAL, z REAL, qx REAL, qy REAL, qz REAL,
                      qw REAL, state TEXT NOT NULL,
    CONSTRAINT "sizes that no image has"
      CHECK (width BETWEEN 1 AND 1000000 AND height BETWEEN 1 AND 1000000),
    CONSTRAINT "poses that are no turn and shift (the quaternion's length is not 1)"
      CHECK (abs(qx * qx + qy * qy + qz * qz + qw * qw - 1) <= 1e-6),
    CONSTRAINT "states that are none of begun, written, complete, left out"
      CHECK (state IN ('begun', 'written', 'complete', 'left out')));
  CREATE TABLE scene_object (
    scene INTEGER NOT NULL REFERENCES scene ("index"),
    object INTEGER NOT NULL REFERENCES object ("index"), x REAL, y REAL, z REAL, qx REAL, qy REAL,
    qz REAL, qw REAL, distance REAL, in_view INTEGER NOT NULL,
    loose_left REAL, loose_top REAL, loose_right REAL, loose_bottom REAL,
    silhouette_left REAL, silhouette_top REAL, silhouette_right REAL, silhouette_bottom REAL,
    visible_left REAL, visible_top REAL, visible_right REAL, visible_bottom REAL,
    silhouette_pixels INTEGER, visible_pixels INTEGER, visibility REAL, truncation REAL,
    dropped INTEGER NOT NULL, mask_agreement REAL,
    PRIMARY KEY (scene, object),
    CONSTRAINT "in_view or dropped that are neither 0 nor 1"
      CHECK (in_view IN (0, 1) AND dropped IN (0, 1)),
    CONSTRAINT "boxes that lack an edge, or end before they begin" CHECK (
      (loose_left IS NULL) + (loose_top IS NULL) + (loose_right IS NULL) +
        (loose_bottom IS NULL) IN (0, 4) AND
      (silhouette_left IS NULL) + (silhouette_top IS NULL) + (silhouette_right IS NULL) +
        (silhouette_bottom IS NULL) IN (0, 4) AND
      (visible_left IS NULL) + (visible_top IS NULL) + (visible_right IS NULL) +
        (visible_bottom IS NULL) IN (0, 4) AND
      loose_left <= loose_right AND loose_top <= loose_bottom AND
      silhouette_left < silhouette_right AND silhouette_top < silhouette_bottom AND
      visible_left < visible_right AND visible_top < visible_bottom),
    CONSTRAINT "counts of pixels below 0, or shares that are not 0 to 1"
      CHECK (silhouette_pixels >= 0 AND visible_pixels >= 0 AND visibility >= 0 AND
             truncation BETWEEN 0 AND 1 AND mask_agreement BETWEEN 0 AND 1),
    CONSTRAINT "a visibility that is not visible_pixels / silhouette_pixels"
      CHECK (silhouette_pixels <= 0 OR abs(visibility * silhouette_pixels - visible_pixels) <=
                                         1e-6 * (1 + visible_pixels)),
    CONSTRAINT "visible boxes without a visible pixel"
      CHECK (visible_left IS NULL OR visible_pixels <> 0),
    CONSTRAINT "more visible pixels than the visible box has"
      CHECK (mask_agreement IS NOT NULL OR visible_left IS NULL OR visible_pixels <=
             (visible_right - visible_left) * (visible_bottom - visible_top) + 1e-6),
    CONSTRAINT "poses that are no turn and shift (the quaternion's length is not 1)"
      CHECK (abs(qx * qx + qy * qy + qz * qz + qw * qw - 1) <= 1e-6),
    CONSTRAINT "poses and distances of which a number is missing" CHECK (
      (x IS NULL) + (y IS NULL) + (z IS NULL) + (qx IS NULL) + (qy IS NULL) + (qz IS NULL) +
        (qw IS NULL) + (distance IS NULL) IN (0, 8)),
    CONSTRAINT "objects without a pose that are seen, or not dropped" CHECK (
      x IS NOT NULL OR (in_view = 0 AND dropped = 1 AND loose_left IS NULL AND
        silhouette_left IS NULL AND visible_left IS NULL AND
        coalesce(silhouette_pixels, 0) = 0 AND coalesce(visible_pixels, 0) = 0))) WITHOUT ROWID;
  CREATE TABLE contact (scene INTEGER NOT NULL REFERENCES scene ("index"),
                        sequence INTEGER NOT NULL, first TEXT NOT NULL, second TEXT NOT NULL,
                        depth REAL NOT NULL, PRIMARY KEY (scene, sequence)) WITHOUT ROWID;
  CREATE TABLE draw (scene INTEGER NOT NULL REFERENCES scene ("index"), name TEXT NOT NULL,
                     value TEXT NOT NULL, PRIMARY KEY (scene, name)) WITHOUT ROWID;
  CREATE TABLE file (path TEXT PRIMARY KEY, writer INTEGER NOT NULL REFERENCES writer ("index"),
                     scene INTEGER REFERENCES scene ("index"), bytes INTEGER NOT NULL,
                     digest TEXT NOT NULL, linked_to TEXT,
    CONSTRAINT "sizes below 0, or digests that are not 64 hexadecimal digits"
      CHECK (bytes >= 0 AND (digest = '' OR
                             (length(digest) = 64 AND digest NOT GLOB '*[^0-9a-f]*'))))
    WITHOUT ROWID;
  CREATE INDEX file_scene ON file (scene);
  CREATE TABLE record (writer INTEGER NOT NULL REFERENCES writer ("index"),
                       scene INTEGER NOT NULL REFERENCES scene ("index"),
                       sequence INTEGER NOT NULL, text TEXT NOT NULL,
                       PRIMARY KEY (writer, scene, sequence)) WITHOUT ROWID;
  CREATE TABLE warning (scene INTEGER NOT NULL, sequence INTEGER NOT NULL, count INTEGER NOT NULL,
                        kind TEXT NOT NULL, detail TEXT NOT NULL, PRIMARY KEY (scene, sequence),
    CONSTRAINT "counts below 1" CHECK (count >= 1)) WITHOUT ROWID;
)sql";

void requireKnownVersion(const std::string& version) {
  if (version == kManifestVersion || version == kVersionOfFirstRelease) return;
  const bool is_between = version == "5" || version == "6";
  throw Error("its format version is '" + version + "', and this release reads " +
              kManifestVersion + ", and " + kVersionOfFirstRelease + " of release 0.1.0" +
              (is_between ? "; that one is of a development version between the two: make the "
                            "dataset again"
                          : "; the release that wrote it reads it"));
}

std::string manifestFile(const std::string& folder, const std::optional<Shard>& shard) {
  std::string name = "manifest.sqlite";
  if (shard) {
    name = "manifest.shard-" + std::to_string(shard->index) + "-of-" +
           std::to_string(shard->count) + ".sqlite";
  }
  return (std::filesystem::path(folder) / name).string();
}

std::string reportFile(const std::string& folder) {
  return (std::filesystem::path(folder) / "report.html").string();
}

std::optional<Shard> shardOfManifest(const std::string& file_name) {
  static const std::regex kName(R"(manifest\.shard-(\d{1,9})-of-(\d{1,9})\.sqlite)");
  std::smatch parts;
  if (!std::regex_match(file_name, parts, kName)) return std::nullopt;
  return Shard{std::stoll(parts[1]), std::stoll(parts[2])};
}

}  // namespace synthetic_dataset::output
