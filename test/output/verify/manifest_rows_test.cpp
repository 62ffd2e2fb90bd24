#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "output/verify/verification_fixture.h"
#include "output/verify/version_4_tables.h"

namespace synthetic_dataset::output {
namespace manifest_rows_test {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A change of a good manifest, and the finding that it causes.
struct Change {
  std::string name;
  std::string sql;
  std::string finding;
};

class VerifyManifest : public VerificationTest, public testing::WithParamInterface<Change> {
 protected:
  VerifyManifest() : VerificationTest("Kitti") {
    write({sceneOfBoth(0), sceneOfBoth(1), sceneOfBoth(2), sceneOfBoth(3)});
  }
};

TEST_P(VerifyManifest, TellsOf) {
  change(GetParam().sql);
  EXPECT_THAT(problems(), Contains(HasSubstr("manifest.sqlite': " + GetParam().finding)));
}

const Change kStructure[] = {
    {"Version", "UPDATE run SET value = '8' WHERE key = 'format_version'",
     "it cannot be read: its format version is '8', and this release reads 7, and 4 of release "
     "0.1.0"},
    {"AnEarlierVersion",
     "UPDATE run SET value = '3' WHERE key = 'format_version'; DROP TABLE motion",
     "it cannot be read: its format version is '3', and this release reads 7, and 4 of release "
     "0.1.0"},
    {"NoVersion", "DELETE FROM run", "it cannot be read: its format version is ''"},
    {"LackingTable", "DROP TABLE contact", "its tables are not those of version 7"},
    {"LackingDraws", "DROP TABLE draw", "its tables are not those of version 7"},
    {"LackingMotions", "DROP TABLE motion", "its tables are not those of version 7"},
    {"MoreTables", "CREATE VIEW more AS SELECT * FROM file",
     "its tables are not those of version 7"},
    {"TextForNumber", "UPDATE scene SET stamp_ns = 'soon'",
     "scene: 4 values of 'stamp_ns' are of another kind; they should be integers"},
    {"Infinity", "UPDATE scene_object SET x = 9e999 WHERE scene = 0",
     "scene_object: 2 values of 'x' are of another kind; they should be finite numbers"},
    {"Bytes", "UPDATE class SET name = x'00ff' WHERE id = 0",
     "class: 1 values of 'name' are of another kind; they should be texts"},
    {"Null",
     "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = replace(sql, 'bytes INTEGER NOT "
     "NULL', 'bytes INTEGER') WHERE name = 'file'",
     "its tables are not those of version 7"},
};

const Change kRun[] = {
    {"State", "UPDATE run SET value = 'done' WHERE key = 'state'",
     "run: found the state 'done'; it should be 'complete'"},
    {"SceneCountThatIsNone", "UPDATE run SET value = 'many' WHERE key = 'scene_count'",
     "it is damaged: its scene_count is 'many'"},
    {"SceneCountWithMore", "UPDATE run SET value = '4 or so' WHERE key = 'scene_count'",
     "run: found the scene_count '4 or so'; it should be '4'"},
    {"SettingsDigest", "INSERT INTO setting VALUES ('camera/far', '20', 0)",
     "run: found the settings_digest '"},
    {"InputDigest", "INSERT INTO input VALUES ('/a.bag', 1, 'ab')",
     "run: found the settings_digest '"},
    {"Shard", "INSERT INTO run VALUES ('shard', '0/2')",
     "run: found the shard '0/2'; it should be ''"},
    {"ShardThatIsNone", "INSERT INTO run VALUES ('shard', '1/0')",
     "it is damaged: its shard is '1/0'"},
    {"UnknownKey", "INSERT INTO run VALUES ('colour', 'red')",
     "run: found the unknown key 'colour'"},
};

const Change kScenes[] = {
    {"AGap", "DELETE FROM scene WHERE \"index\" = 1; DELETE FROM scene_object WHERE scene = 1",
     "scene: missing: 1 (of 4)"},
    {"TheEndMissing", "UPDATE run SET value = '9000000000000000000' WHERE key = 'scene_count'",
     "scene: missing: 4, 5, 6 and more (of 9000000000000000000)"},
    {"TooManyScenes", "UPDATE run SET value = '2' WHERE key = 'scene_count'",
     "scene: found 2, 3; they do not belong to 2 scenes from 0 on"},
    {"ASceneThatIsNotSafe", "UPDATE scene SET state = 'written' WHERE \"index\" = 2",
     "scene: the run is complete, and these are not: 2"},
    {"AStateThatIsNone", "UPDATE scene SET state = 'good' WHERE \"index\" = 2",
     "scene: states that are none of begun, written, complete, left out: scene 2"},
    {"AnInstant", "UPDATE scene SET instant = 7 WHERE \"index\" = 2",
     "scene: instants that do not follow from index and number of cameras: scene 2"},
    {"AnUnknownCamera", "UPDATE scene SET camera = 'rear'",
     "scene: cameras that the table camera does not have: scene 0, scene 1, scene 2 and 1 more"},
    {"ACameraWhoseTurnItIsNot", "INSERT INTO camera VALUES (1, 'rear', 'rear_link', 640, 480)",
     "scene: cameras out of turn: scene 1, scene 3"},
    {"AQuaternion", "UPDATE scene SET qw = 0.9 WHERE \"index\" = 3",
     "scene: poses that are no turn and shift (the quaternion's length is not 1): scene 3"},
};

const Change kReferences[] = {
    {"AnObjectsClass", "DELETE FROM class WHERE id = 1",
     "object: classes that the table class does not have: object 1"},
    {"ALackingObject", "DELETE FROM scene_object WHERE scene = 2 AND object = 0",
     "scene: not as many rows in scene_object as there are objects: scene 2"},
    {"AnObjectTooMany",
     "INSERT INTO scene_object SELECT scene, 5, x, y, z, qx, qy, qz, qw, distance, in_view, "
     "loose_left, loose_top, loose_right, loose_bottom, silhouette_left, silhouette_top, "
     "silhouette_right, silhouette_bottom, visible_left, visible_top, visible_right, "
     "visible_bottom, silhouette_pixels, visible_pixels, visibility, truncation, dropped, "
     "mask_agreement FROM scene_object WHERE scene = 1 AND object = 1",
     "scene_object: objects that the table object does not have: scene 1 object 5"},
    {"MeasuresOfNoScene", "UPDATE scene_object SET scene = 9 WHERE scene = 3",
     "scene_object: scenes that the table scene does not have: scene 9 object 0"},
    {"AContactOfNoScene", "INSERT INTO contact VALUES (9, 0, 'a', 'b', 0.1)",
     "contact: scenes that the table scene does not have: scene 9"},
    {"ADrawOfNoScene", "INSERT INTO draw VALUES (9, 'lights/sun/x', '1')",
     "draw: scenes that the table scene does not have: scene 9 name lights/sun/x"},
    {"AFilesWriter", "UPDATE file SET writer = 4 WHERE path LIKE '%label_2/000002.txt'",
     "file: writers that the table writer does not have: w/training/label_2/000002.txt"},
    {"AFilesScene", "UPDATE file SET scene = 44 WHERE path LIKE '%label_2/000002.txt'",
     "file: scenes that the table scene does not have: w/training/label_2/000002.txt"},
    {"ALinkToNothing", "UPDATE file SET linked_to = 'w/x' WHERE path LIKE '%label_2/000002.txt'",
     "file: links to anything but a listed file of the same size and digest: "},
    {"ARecordsWriter", "UPDATE record SET writer = 1 WHERE scene = 0",
     "record: writers that the table writer does not have: writer 1 scene 0"},
    {"ARecordsScene", "UPDATE record SET scene = 9 WHERE scene = 0",
     "record: scenes that the table scene does not have: writer 0 scene 9"},
    {"AWarningsScene", "INSERT INTO warning VALUES (9, 0, 1, 'gap', '')",
     "warning: scenes that the table scene does not have: scene 9"},
};

const Change kNumbers[] = {
    {"WritersNumbers", "UPDATE writer SET \"index\" = 3",
     "writer: indices that do not count from 0: writer 3"},
    {"CamerasNumbers", "UPDATE camera SET \"index\" = 3",
     "camera: indices that do not count from 0: camera 3"},
    {"ObjectsNumbers", "UPDATE object SET \"index\" = 3 WHERE name = 'b'",
     "object: indices that do not count from 0: object 3"},
    {"ClassesNumbers", "UPDATE class SET id = 5000000000 WHERE id = 1",
     "class: ids that are no numbers of classes: class 5000000000"},
    {"CamerasSizes", "UPDATE camera SET width = 5000000000",
     "camera: sizes that no image has: camera 0"},
    {"ScenesSizes", "UPDATE scene SET height = 0 WHERE \"index\" = 2",
     "scene: sizes that no image has: scene 2"},
    {"MotionsNumbers", "UPDATE motion SET \"index\" = 3",
     "motion: indices that do not count from 0: motion 3"},
    {"MotionsGaps",
     "UPDATE motion SET instant_count = 1; INSERT INTO motion VALUES (1, 'run', 2, 3)",
     "motion: instants that do not follow those of the motion before: motion 1"},
    {"MotionsStarts", "UPDATE motion SET first_instant = 1",
     "motion: instants that do not follow those of the motion before: motion 0"},
    {"MotionsWithoutScenes", "INSERT INTO motion VALUES (1, 'run', 4, 0)",
     "motion: no instants: motion 1"},
    {"MotionsSum", "UPDATE motion SET instant_count = 5",
     "motion: a total of instants that is not the run's: 4"},
    {"NoMotion", "DELETE FROM motion", "motion: a total of instants that is not the run's: 4"},
    {"RecordsSequences", "UPDATE record SET sequence = sequence + 2 WHERE scene = 2",
     "record: sequences that do not count from 0: writer 0 scene 2"},
    {"ContactsSequences", "INSERT INTO contact VALUES (1, 1, 'a', 'b', 0.1)",
     "contact: sequences that do not count from 0: scene 1"},
    {"DrawsValues", "UPDATE draw SET value = 'oak' WHERE scene = 1 AND name = 'floor'",
     "draw: values that are not JSON: scene 1 floor"},
    {"WarningsSequences", "INSERT INTO warning VALUES (-1, 1, 1, 'gap', '')",
     "warning: sequences that do not count from 0: scene -1"},
    {"WarningsCounts", "INSERT INTO warning VALUES (-1, 0, 0, 'gap', '')",
     "warning: counts below 1: scene -1"},
    {"Digests", "UPDATE file SET digest = 'XYZ' WHERE path LIKE '%label_2/000002.txt'",
     "file: sizes below 0, or digests that are not 64 hexadecimal digits: "
     "w/training/label_2/000002.txt"},
};

const Change kMeasures[] = {
    {"Flags", "UPDATE scene_object SET dropped = 2 WHERE scene = 1 AND object = 0",
     "scene_object: in_view or dropped that are neither 0 nor 1: scene 1 object 0"},
    {"LackingEdges", "UPDATE scene_object SET visible_top = NULL WHERE scene = 1 AND object = 0",
     "scene_object: boxes that lack an edge, or end before they begin: scene 1 object 0"},
    {"BoxesThatEndBeforeTheyBegin",
     "UPDATE scene_object SET silhouette_left = 1000 WHERE scene = 1 AND object = 0",
     "scene_object: boxes that lack an edge, or end before they begin: scene 1 object 0"},
    {"Shares", "UPDATE scene_object SET truncation = 1.5 WHERE scene = 1 AND object = 0",
     "scene_object: counts of pixels below 0, or shares that are not 0 to 1: scene 1 object 0"},
    {"Visibility", "UPDATE scene_object SET visibility = 0.5 WHERE scene = 1 AND object = 0",
     "scene_object: a visibility that is not visible_pixels / silhouette_pixels: scene 1 object 0"},
    {"InView", "UPDATE scene_object SET in_view = 0 WHERE scene = 1 AND object = 0",
     "scene_object: an in_view that contradicts whether the loose box overlaps the image: "
     "scene 1 object 0"},
    {"VisibleBoxes", "UPDATE scene_object SET visible_left = -2 WHERE scene = 1 AND object = 0",
     "scene_object: visible boxes that leave the image: scene 1 object 0"},
    {"VisibleBoxesOfNothing",
     "UPDATE scene_object SET visible_pixels = 0, visibility = 0 WHERE scene = 1 AND object = 0",
     "scene_object: visible boxes without a visible pixel: scene 1 object 0"},
    {"Digestless", "UPDATE file SET digest = '' WHERE path LIKE '%label_2/000002.txt'",
     "file: digests that are missing: w/training/label_2/000002.txt"},
    {"TooManyPixels",
     "UPDATE scene_object SET visible_pixels = 2001, silhouette_pixels = 2001 WHERE scene = 1 AND "
     "object = 0",
     "scene_object: more visible pixels than the visible box has: scene 1 object 0"},
    {"Quaternions", "UPDATE scene_object SET qw = 0 WHERE scene = 1 AND object = 0",
     "scene_object: poses that are no turn and shift (the quaternion's length is not 1): scene 1 "
     "object 0"},
    {"LackingNumbers", "UPDATE scene_object SET qw = NULL WHERE scene = 1 AND object = 0",
     "scene_object: poses and distances of which a number is missing: scene 1 object 0"},
    {"SeenNowhere",
     "UPDATE scene_object SET x = NULL, y = NULL, z = NULL, qx = NULL, qy = NULL, qz = NULL, qw = "
     "NULL, distance = NULL WHERE scene = 1 AND object = 0",
     "scene_object: objects without a pose that are seen, or not dropped: scene 1 object 0"},
    {"Distances", "UPDATE scene_object SET distance = 11 WHERE scene = 1 AND object = 0",
     "scene_object: a distance that is not the one between the poses of object and camera: scene "
     "1 object 0"},
};

/// Changes that the tables of this version refuse, so that no such file can be made.
const Change kNames[] = {
    {"MotionsNames",
     "UPDATE motion SET instant_count = 1; INSERT INTO motion VALUES (1, 'walk', 1, 3)",
     "motion: UNIQUE constraint failed: motion.name: motion 1"},
    {"WritersNames", "INSERT INTO writer VALUES (1, 'w', 'test/X', 'x/')",
     "writer: UNIQUE constraint failed: writer.name: writer 1"},
    {"CamerasNames", "INSERT INTO camera VALUES (1, 'camera', 'f', 640, 480)",
     "camera: UNIQUE constraint failed: camera.name: camera 1"},
    {"ObjectsNames", "UPDATE object SET name = 'a'",
     "object: UNIQUE constraint failed: object.name: object 1"},
    {"Sizes", "UPDATE camera SET width = 0", "camera: sizes that no image has: camera 0"},
    {"Classes", "DELETE FROM class WHERE id = 1",
     "object: classes that the table class does not have: object 1"},
    {"MoreColumns", "ALTER TABLE draw ADD COLUMN more TEXT",
     "its tables are not those of version 4"},
};

const auto kNameOf = [](const testing::TestParamInfo<Change>& change) { return change.param.name; };

class VerifyMotions : public VerificationTest {
 protected:
  VerifyMotions() : VerificationTest("Kitti") {
    write({sceneOfBoth(0), sceneOfBoth(1), sceneOfBoth(2), sceneOfBoth(3)});
  }
};

TEST_F(VerifyMotions, FindsNothingInSeveralThatFollowOneAnother) {
  change(
      "UPDATE motion SET instant_count = 1; INSERT INTO motion VALUES (1, 'run', 1, 2), (2, "
      "'rest', "
      "3, 1)");
  EXPECT_THAT(problems(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Structure, VerifyManifest, testing::ValuesIn(kStructure), kNameOf);
INSTANTIATE_TEST_SUITE_P(Run, VerifyManifest, testing::ValuesIn(kRun), kNameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, VerifyManifest, testing::ValuesIn(kScenes), kNameOf);
INSTANTIATE_TEST_SUITE_P(References, VerifyManifest, testing::ValuesIn(kReferences), kNameOf);
INSTANTIATE_TEST_SUITE_P(Numbers, VerifyManifest, testing::ValuesIn(kNumbers), kNameOf);
INSTANTIATE_TEST_SUITE_P(Measures, VerifyManifest, testing::ValuesIn(kMeasures), kNameOf);

TEST_F(VerifyManifest, SaysWhichReleasesManifestsItReads) {
  change("UPDATE run SET value = '6' WHERE key = 'format_version'");
  EXPECT_THAT(problems(),
              ElementsAre(HasSubstr("its format version is '6', and this release reads 7, "
                                    "and 4 of release 0.1.0")));
}

TEST_F(VerifyManifest, GivesNoWriterASceneThatTheRunDoesNotKnow) {
  change("UPDATE scene SET camera = 'rear' WHERE \"index\" > 0");
  EXPECT_THAT(problems(),
              Contains(HasSubstr("the labels of scene 1, and of others like it, cannot be "
                                 "checked: the run does not know its camera 'rear'")));
}

/// A manifest as written by version 0.1 of this software.
class VerifyEarlierManifest : public VerifyManifest {
 protected:
  VerifyEarlierManifest() {
    std::string copying = kVersion4Tables;
    copying += "ATTACH '" + (folder_ / "manifest.sqlite").string() + "' AS later;";
    for (const char* table :
         {"run", "setting", "software", "input", "writer", "class", "motion", "camera", "object",
          "scene", "scene_object", "contact", "draw", "file", "record", "warning"}) {
      copying += std::string("INSERT INTO ") + table + " SELECT * FROM later." + table + ";";
    }
    change(copying + "UPDATE run SET value = '4' WHERE key = 'format_version'", "earlier");
    std::filesystem::rename(folder_ / "earlier", folder_ / "manifest.sqlite");
  }
};

TEST_P(VerifyEarlierManifest, TellsOf) {
  EXPECT_THAT(problems(), IsEmpty());
  change(GetParam().sql);
  EXPECT_THAT(problems(), Contains(HasSubstr("manifest.sqlite': " + GetParam().finding)));
}

INSTANTIATE_TEST_SUITE_P(Names, VerifyEarlierManifest, testing::ValuesIn(kNames), kNameOf);

class VerifyDamagedManifest : public VerificationTest {
 protected:
  VerifyDamagedManifest() : VerificationTest("Kitti") { write({sceneOfBoth(0), sceneOfBoth(1)}); }

  [[nodiscard]] std::string manifest() const { return (folder_ / "manifest.sqlite").string(); }
};

TEST_F(VerifyDamagedManifest, TellsOfAFileThatIsNoDatabase) {
  std::ofstream(manifest(), std::ios::binary) << "not a database, and long enough to be one";
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("it cannot be read: ")));
}

TEST_F(VerifyDamagedManifest, TellsOfAnEmptyFile) {
  std::filesystem::resize_file(manifest(), 0);
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("manifest.sqlite': ")));
}

TEST_F(VerifyDamagedManifest, TellsOfAFolder) {
  std::filesystem::remove(manifest());
  std::filesystem::create_directory(manifest());
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("it cannot be read: ")));
}

TEST_F(VerifyDamagedManifest, TellsOfOneThatIsCutShort) {
  std::filesystem::resize_file(manifest(), std::filesystem::file_size(manifest()) / 2);
  EXPECT_THAT(problems(), testing::Not(IsEmpty()));
}

TEST_F(VerifyDamagedManifest, SurvivesBytesThatAreChanged) {
  const std::string good = test::readFile(manifest());
  for (std::size_t at = 100; at < good.size(); at += 997) {  // after SQLite's header
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x5a);
    std::ofstream(manifest(), std::ios::binary) << bad;
    EXPECT_NO_THROW((void)problems(VerificationDepth::kSizes)) << at;
  }
}

}  // namespace manifest_rows_test
}  // namespace synthetic_dataset::output
