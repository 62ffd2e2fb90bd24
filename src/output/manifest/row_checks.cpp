#include "output/manifest/row_checks.h"

namespace synthetic_dataset::output {
namespace {

struct RowCheck {
  const char* fault;
  const char* rows;  ///< SQL for a text that names each row that has it
};

constexpr RowCheck kReferences[] = {
    {"object: classes that the table class does not have",
     "SELECT 'object ' || \"index\" FROM object WHERE class NOT IN (SELECT id FROM class)"},
    {"scene: cameras that the table camera does not have",
     "SELECT 'scene ' || \"index\" FROM scene WHERE camera NOT IN (SELECT name FROM camera)"},
    {"scene_object: scenes that the table scene does not have",
     "SELECT 'scene ' || scene || ' object ' || object FROM scene_object WHERE scene NOT IN "
     "(SELECT \"index\" FROM scene)"},
    {"scene_object: objects that the table object does not have",
     "SELECT 'scene ' || scene || ' object ' || object FROM scene_object WHERE object NOT IN "
     "(SELECT \"index\" FROM object)"},
    {"scene: not as many rows in scene_object as there are objects",
     "SELECT 'scene ' || \"index\" FROM scene s WHERE state <> 'begun' AND (SELECT count(*) FROM "
     "scene_object WHERE scene = s.\"index\") <> (SELECT count(*) FROM object)"},
    {"contact: scenes that the table scene does not have",
     "SELECT 'scene ' || scene FROM contact WHERE scene NOT IN (SELECT \"index\" FROM scene)"},
    {"draw: scenes that the table scene does not have",
     "SELECT 'scene ' || scene || ' ' || name FROM draw WHERE scene NOT IN (SELECT \"index\" FROM "
     "scene)"},
    {"file: writers that the table writer does not have",
     "SELECT path FROM file WHERE writer NOT IN (SELECT \"index\" FROM writer)"},
    {"file: scenes that the table scene does not have",
     "SELECT path FROM file WHERE scene NOT NULL AND scene NOT IN (SELECT \"index\" FROM scene)"},
    {"file: linked to what is no listed file of the same size and digest",
     "SELECT path FROM file f WHERE linked_to NOT NULL AND NOT EXISTS (SELECT 1 FROM file t WHERE "
     "t.path = f.linked_to AND t.bytes = f.bytes AND t.digest = f.digest)"},
    {"record: writers that the table writer does not have",
     "SELECT 'writer ' || writer || ' scene ' || scene FROM record WHERE writer NOT IN (SELECT "
     "\"index\" FROM writer)"},
    {"record: scenes that the table scene does not have",
     "SELECT 'writer ' || writer || ' scene ' || scene FROM record WHERE scene NOT IN (SELECT "
     "\"index\" FROM scene)"},
    {"warning: scenes that the table scene does not have",
     "SELECT 'scene ' || scene FROM warning WHERE scene <> -1 AND scene NOT IN (SELECT \"index\" "
     "FROM scene)"},
};

constexpr RowCheck kNumbers[] = {
    {"writer: indices that do not count from 0",
     "SELECT name FROM writer w WHERE \"index\" <> (SELECT count(*) FROM writer WHERE \"index\" < "
     "w.\"index\")"},
    {"camera: indices that do not count from 0",
     "SELECT name FROM camera c WHERE \"index\" <> (SELECT count(*) FROM camera WHERE \"index\" < "
     "c.\"index\")"},
    {"object: indices that do not count from 0",
     "SELECT name FROM object o WHERE \"index\" <> (SELECT count(*) FROM object WHERE \"index\" < "
     "o.\"index\")"},
    {"class: ids that are no numbers of classes",
     "SELECT name FROM class WHERE id NOT BETWEEN 0 AND 2147483647"},
    {"camera: sizes that no image has",
     "SELECT name FROM camera WHERE width NOT BETWEEN 1 AND 1000000 OR height NOT BETWEEN 1 AND "
     "1000000"},
    {"scene: sizes that no image has",
     "SELECT 'scene ' || \"index\" FROM scene WHERE width NOT BETWEEN 1 AND 1000000 OR height NOT "
     "BETWEEN 1 AND 1000000"},
    {"motion: indices that do not count from 0",
     "SELECT name FROM motion m WHERE \"index\" <> (SELECT count(*) FROM motion WHERE \"index\" < "
     "m.\"index\")"},
    {"motion: names that are there twice",
     "SELECT name FROM motion GROUP BY name HAVING count(*) > 1"},
    {"motion: instants that do not follow those of the motion before, or are none",
     "SELECT name FROM motion m WHERE instant_count < 1 OR first_instant <> (SELECT "
     "coalesce(sum(instant_count), 0) FROM motion WHERE \"index\" < m.\"index\")"},
    {"motion: instants in all that are not those of the run",
     "SELECT value FROM run WHERE key = 'scene_count' AND CAST(value AS INTEGER) <> (SELECT "
     "coalesce(sum(instant_count), 0) FROM motion) * (SELECT max(1, count(*)) FROM camera)"},
    {"writer: names that are there twice",
     "SELECT name FROM writer GROUP BY name HAVING count(*) > 1"},
    {"camera: names that are there twice",
     "SELECT name FROM camera GROUP BY name HAVING count(*) > 1"},
    {"object: names that are there twice",
     "SELECT name FROM object GROUP BY name HAVING count(*) > 1"},
    {"scene: instants that do not follow from index and number of cameras",
     "SELECT 'scene ' || \"index\" FROM scene WHERE instant <> \"index\" / (SELECT max(1, "
     "count(*)) "
     "FROM camera)"},
    {"scene: cameras whose turn it is not",
     "SELECT 'scene ' || \"index\" FROM scene s WHERE EXISTS (SELECT 1 FROM camera) AND camera <> "
     "(SELECT name FROM camera c WHERE c.\"index\" = s.\"index\" % (SELECT count(*) FROM camera))"},
    {"scene: states that are none of begun, written, complete",
     "SELECT 'scene ' || \"index\" FROM scene WHERE state NOT IN ('begun', 'written', 'complete')"},
    {"record: sequences that do not count from 0",
     "SELECT 'writer ' || writer || ' scene ' || scene FROM record GROUP BY writer, scene HAVING "
     "min(sequence) <> 0 OR max(sequence) <> count(*) - 1"},
    {"contact: sequences that do not count from 0",
     "SELECT 'scene ' || scene FROM contact GROUP BY scene HAVING min(sequence) <> 0 OR "
     "max(sequence) <> count(*) - 1"},
    {"draw: values that are not JSON",
     "SELECT 'scene ' || scene || ' ' || name FROM draw WHERE NOT json_valid(value)"},
    {"warning: sequences that do not count from 0",
     "SELECT 'scene ' || scene FROM warning GROUP BY scene HAVING min(sequence) <> 0 OR "
     "max(sequence) <> count(*) - 1"},
    {"warning: counts below 1", "SELECT 'scene ' || scene FROM warning WHERE count < 1"},
    {"scene: poses that are no turn and shift (the quaternion's length is not 1)",
     "SELECT 'scene ' || \"index\" FROM scene WHERE abs(qx * qx + qy * qy + qz * qz + qw * qw - 1) "
     "> 1e-6"},
    {"file: sizes below 0, or digests that are not 64 hexadecimal digits",
     "SELECT path FROM file f WHERE (bytes < 0 OR length(digest) <> 64 OR digest GLOB "
     "'*[^0-9a-f]*') AND (scene NOT NULL OR (SELECT value FROM run WHERE key = 'state') = "
     "'complete')"},
};

/// What a query of measures begins with: rows of scene_object with the scenes that they belong to.
constexpr const char* kOfMeasures =
    "SELECT 'scene ' || m.scene || ' object ' || m.object FROM scene_object m JOIN scene s ON "
    "s.\"index\" = m.scene ";

// Measures of objects. What is computed anew here, in another order than the run did it, may differ
// in its last bits.
constexpr RowCheck kMeasures[] = {
    {"scene_object: in_view or dropped that are neither 0 nor 1",
     "WHERE in_view NOT IN (0, 1) OR dropped NOT IN (0, 1)"},
    {"scene_object: boxes that lack an edge, or end before they begin",
     "WHERE (loose_left IS NULL) + (loose_top IS NULL) + (loose_right IS NULL) + (loose_bottom IS "
     "NULL) NOT IN (0, 4) OR (silhouette_left IS NULL) + (silhouette_top IS NULL) + "
     "(silhouette_right IS NULL) + (silhouette_bottom IS NULL) NOT IN (0, 4) OR (visible_left IS "
     "NULL) + (visible_top IS NULL) + (visible_right IS NULL) + (visible_bottom IS NULL) NOT IN "
     "(0, 4) OR loose_left > loose_right OR loose_top > loose_bottom OR silhouette_left >= "
     "silhouette_right OR silhouette_top >= silhouette_bottom OR visible_left >= visible_right OR "
     "visible_top >= visible_bottom"},
    {"scene_object: counts of pixels below 0, or shares that are not 0 to 1",
     "WHERE silhouette_pixels < 0 OR visible_pixels < 0 OR truncation NOT BETWEEN 0 AND 1 OR "
     "mask_agreement NOT BETWEEN 0 AND 1 OR visibility < 0"},
    {"scene_object: a visibility that is not visible_pixels / silhouette_pixels",
     "WHERE silhouette_pixels > 0 AND abs(visibility * silhouette_pixels - visible_pixels) > "
     "1e-6 * (1 + visible_pixels)"},
    {"scene_object: an in_view that is not whether the loose box shares area with the image",
     "WHERE in_view <> coalesce(max(loose_left, -0.5) < min(loose_right, s.width - 0.5) AND "
     "max(loose_top, -0.5) < min(loose_bottom, s.height - 0.5), 0)"},
    {"scene_object: visible boxes that leave the image, or are there without a visible pixel",
     "WHERE visible_left < -0.5 OR visible_top < -0.5 OR visible_right > s.width - 0.5 OR "
     "visible_bottom > s.height - 0.5 OR (visible_left NOT NULL AND visible_pixels = 0)"},
    {"scene_object: more visible pixels than the visible box has",
     "WHERE mask_agreement IS NULL AND visible_left NOT NULL AND visible_pixels > (visible_right "
     "- visible_left) * (visible_bottom - visible_top) + 1e-6"},
    {"scene_object: poses that are no turn and shift (the quaternion's length is not 1)",
     "WHERE abs(m.qx * m.qx + m.qy * m.qy + m.qz * m.qz + m.qw * m.qw - 1) > 1e-6"},
    {"scene_object: a distance that is not the one between the poses of object and camera",
     "WHERE abs((m.x - s.x) * (m.x - s.x) + (m.y - s.y) * (m.y - s.y) + (m.z - s.z) * (m.z - s.z) "
     "- distance * distance) > 1e-6 * (1 + distance * distance)"},
};

template <std::size_t count>
void check(const SqliteDatabase& database, const std::string& beginning,
           const RowCheck (&checks)[count], std::vector<std::string>& problems) {
  for (const RowCheck& each : checks) {
    const std::string rows = firstRows(database, beginning + each.rows);
    if (!rows.empty()) problems.push_back(std::string(each.fault) + ": " + rows);
  }
}

}  // namespace

std::string firstRows(const SqliteDatabase& database, const std::string& sql) {
  constexpr int kNamed = 3;
  std::string named;
  std::int64_t count = 0;
  SqliteStatement rows(database, sql);
  while (rows.step()) {
    if (++count <= kNamed) named += (named.empty() ? "" : ", ") + rows.text(0);
  }
  if (count > kNamed) named += " and " + std::to_string(count - kNamed) + " more";
  return named;
}

std::vector<std::string> rowProblems(const SqliteDatabase& database) {
  std::vector<std::string> problems;
  check(database, "", kReferences, problems);
  check(database, "", kNumbers, problems);
  check(database, kOfMeasures, kMeasures, problems);
  return problems;
}

}  // namespace synthetic_dataset::output
