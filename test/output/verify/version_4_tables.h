#pragma once

namespace synthetic_dataset::output {

/// The tables of a manifest of format version 4, which had no constraints.
constexpr const char* kVersion4Tables = R"sql(
  CREATE TABLE run (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE setting (name TEXT PRIMARY KEY, value TEXT NOT NULL,
                        is_default INTEGER NOT NULL) WITHOUT ROWID;
  CREATE TABLE software (name TEXT PRIMARY KEY, version TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE input (path TEXT PRIMARY KEY, bytes INTEGER NOT NULL,
                      digest TEXT NOT NULL) WITHOUT ROWID;
  CREATE TABLE writer ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
                       output_folder TEXT NOT NULL);
  CREATE TABLE class (id INTEGER PRIMARY KEY, name TEXT NOT NULL);
  CREATE TABLE motion ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL,
                       first_instant INTEGER NOT NULL, instant_count INTEGER NOT NULL);
  CREATE TABLE camera ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL, frame TEXT NOT NULL,
                       width INTEGER NOT NULL, height INTEGER NOT NULL);
  CREATE TABLE object ("index" INTEGER PRIMARY KEY, name TEXT NOT NULL, class INTEGER NOT NULL,
                       id TEXT NOT NULL);
  CREATE TABLE scene ("index" INTEGER PRIMARY KEY, instant INTEGER NOT NULL,
                      stamp_ns INTEGER NOT NULL, camera TEXT NOT NULL, width INTEGER NOT NULL,
                      height INTEGER NOT NULL, split TEXT NOT NULL, seed INTEGER NOT NULL, x REAL,
                      y REAL, z REAL, qx REAL, qy REAL, qz REAL, qw REAL, state TEXT NOT NULL);
  CREATE TABLE scene_object (
    scene INTEGER NOT NULL, object INTEGER NOT NULL, x REAL NOT NULL, y REAL NOT NULL,
    z REAL NOT NULL, qx REAL NOT NULL, qy REAL NOT NULL, qz REAL NOT NULL, qw REAL NOT NULL,
    distance REAL NOT NULL, in_view INTEGER NOT NULL,
    loose_left REAL, loose_top REAL, loose_right REAL, loose_bottom REAL,
    silhouette_left REAL, silhouette_top REAL, silhouette_right REAL, silhouette_bottom REAL,
    visible_left REAL, visible_top REAL, visible_right REAL, visible_bottom REAL,
    silhouette_pixels INTEGER, visible_pixels INTEGER, visibility REAL, truncation REAL,
    dropped INTEGER NOT NULL, mask_agreement REAL,
    PRIMARY KEY (scene, object)) WITHOUT ROWID;
  CREATE TABLE contact (scene INTEGER NOT NULL, sequence INTEGER NOT NULL, first TEXT NOT NULL,
                        second TEXT NOT NULL, depth REAL NOT NULL,
                        PRIMARY KEY (scene, sequence)) WITHOUT ROWID;
  CREATE TABLE draw (scene INTEGER NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL,
                     PRIMARY KEY (scene, name)) WITHOUT ROWID;
  CREATE TABLE file (path TEXT PRIMARY KEY, writer INTEGER NOT NULL, scene INTEGER,
                     bytes INTEGER NOT NULL, digest TEXT NOT NULL, linked_to TEXT) WITHOUT ROWID;
  CREATE INDEX file_scene ON file (scene);
  CREATE TABLE record (writer INTEGER NOT NULL, scene INTEGER NOT NULL,
                       sequence INTEGER NOT NULL, text TEXT NOT NULL,
                       PRIMARY KEY (writer, scene, sequence)) WITHOUT ROWID;
  CREATE TABLE warning (scene INTEGER NOT NULL, sequence INTEGER NOT NULL, count INTEGER NOT NULL,
                        kind TEXT NOT NULL, detail TEXT NOT NULL,
                        PRIMARY KEY (scene, sequence)) WITHOUT ROWID;
)sql";

}  // namespace synthetic_dataset::output
