#include "base/yaml_text/yaml_edit.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/json_text.h"
#include "base/yaml_value.h"
#include "support/error_messages.h"
#include "support/source_folder.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

namespace fs = std::filesystem;

std::string set(const std::string& text, const YamlPath& path, const Value& value) {
  return editYaml(text, "settings.yaml", {{path, value}}, {});
}

std::string removed(const std::string& text, const YamlPath& path) {
  return editYaml(text, "settings.yaml", {{path, std::nullopt}}, {});
}

/// Collects the paths of all values in a tree, including groups.
void collectPaths(const Value& value, const YamlPath& path, std::vector<YamlPath>& paths) {
  if (!path.empty()) paths.push_back(path);
  if (const auto* map = value.as<Value::Map>()) {
    for (const auto& [name, entry] : *map) {
      YamlPath inner = path;
      inner.emplace_back(name);
      collectPaths(entry, inner, paths);
    }
  } else if (const auto* list = value.as<Value::List>()) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      YamlPath inner = path;
      inner.emplace_back(i);
      collectPaths((*list)[i], inner, paths);
    }
  }
}

std::vector<YamlPath> pathsOf(const std::string& text) {
  std::vector<YamlPath> paths;
  collectPaths(readYamlText(text, "text"), {}, paths);
  return paths;
}

/// A copy of a tree with one value changed, or removed if `value` is empty.
Value copyWith(const Value& tree, const YamlPath& path, std::size_t depth,
               const std::optional<Value>& value) {
  const bool is_last = depth + 1 == path.size();
  if (const auto* map = tree.as<Value::Map>()) {
    Value::Map copy;
    for (const auto& [name, entry] : *map) {
      if (name != std::get<std::string>(path[depth])) {
        copy[name] = entry;
      } else if (is_last) {
        if (value) copy[name] = *value;
      } else {
        const Value inner = copyWith(entry, path, depth + 1, value);
        const auto* left = inner.as<Value::Map>();
        if (left == nullptr || !left->empty()) copy[name] = inner;
      }
    }
    return copy;
  }
  Value::List copy;
  const auto& list = *tree.as<Value::List>();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i != std::get<std::size_t>(path[depth])) {
      copy.push_back(list[i]);
    } else if (!is_last) {
      copy.push_back(copyWith(list[i], path, depth + 1, value));
    } else if (value) {
      copy.push_back(*value);
    }
  }
  return copy;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> commentLines(const std::string& text) {
  std::vector<std::string> comments;
  for (const std::string& line : linesOf(text)) {
    const std::size_t word = line.find_first_not_of(' ');
    if (word != std::string::npos && line[word] == '#') comments.push_back(line);
  }
  return comments;
}

void expectText(const std::string& text, const YamlPath& path, const std::optional<Value>& value) {
  const Value expected = copyWith(readYamlText(text, "before"), path, 0, value);
  std::string edited;
  ASSERT_NO_THROW(edited = editYaml(text, "settings.yaml", {{path, value}}, {})) << pathText(path);
  const Value found = readYamlText(edited, "after");
  const bool is_empty = expected.as<Value::Map>()->empty();
  EXPECT_EQ(is_empty ? jsonText(Value::Map{}) : jsonText(expected),
            found.isNull() ? jsonText(Value::Map{}) : jsonText(found))
      << pathText(path) << "\n"
      << edited;
}

/// Removes each value of a text, and sets it to values of various kinds.
void expectEveryEditExact(const std::string& text) {
  const std::vector<Value> values = {
      Value("a text"),
      Value("quoted: \"#'"),
      Value(7),
      Value(0.25),
      Value(true),
      Value(Value::List{Value(1), Value("two")}),
      Value(Value::List{
          Value(Value::Map{{"name", Value("hall")}, {"deep", Value(Value::List{Value(1)})}})}),
      Value(
          Value::Map{{"uniform", Value(Value::List{Value(0.5), Value(2.5)})}, {"on", Value("x")}})};
  std::size_t next = 0;
  for (const YamlPath& path : pathsOf(text)) {
    expectText(text, path, std::nullopt);
    expectText(text, path, values[next++ % values.size()]);
    expectText(text, path, values[next % values.size()]);
  }
}

TEST(YamlEdit, ChangesOneNumberAndNothingElse) {
  const std::string text =
      "# The camera.\ncamera:\n  pose: {xyz: [1.0, 2.0, 3.0], rpy: [0, 0, 0]}  # on the mast\n"
      "  far: 50.0\t# metres\n";
  EXPECT_EQ(
      "# The camera.\ncamera:\n  pose: {xyz: [1.0, 2.5, 3.0], rpy: [0, 0, 0]}  # on the mast\n"
      "  far: 50.0\t# metres\n",
      set(text, {"camera", "pose", "xyz"}, Value::List{Value(1), Value(2.5), Value(3)}));
  EXPECT_EQ(
      "# The camera.\ncamera:\n  pose: {xyz: [1.0, 2.0, 3.0], rpy: [0, 0, 0]}  # on the mast\n"
      "  far: 60.0\t# metres\n",
      set(text, {"camera", "far"}, Value(60)));
}

TEST(YamlEdit, KeepsQuotesAndAngles) {
  EXPECT_EQ("a: 'it''s'\nb: \"$(dirname)/x\"\nc: deg(45)\n",
            set("a: 'was'\nb: \"$(dirname)/x\"\nc: deg(45)\n", {"a"}, "it's"));
  EXPECT_EQ("c: deg(30)  # tilt\n", set("c: deg(45)  # tilt\n", {"c"}, "deg(30)"));
  EXPECT_EQ("b: \"$(dirname)/y\"\n", set("b: plain\n", {"b"}, "$(dirname)/y"));
  EXPECT_EQ("c: deg(45)\n",
            set("c: deg(45)\n", {"c"}, readYamlText("c: deg(45)", "").as<Value::Map>()->at("c")));
}

TEST(YamlEdit, AddsMissingGroupsWithTheFilesIndentation) {
  EXPECT_EQ("camera:\n    far: 5\n    pose:\n        xyz: [1, 2, 3]\n# end\n",
            set("camera:\n    far: 5\n# end\n", {"camera", "pose", "xyz"},
                Value::List{Value(1), Value(2), Value(3)}));
  EXPECT_EQ("# only a comment\nseed: 3\n", set("# only a comment", {"seed"}, 3));
  EXPECT_EQ("", removed(set("", {"a", "b"}, 3), {"a", "b"}));
}

TEST(YamlEdit, PutsNewNamesInTheirUsualOrder) {
  const auto order = [](const YamlPath&) {
    return std::vector<std::string>{"bag_file", "world", "camera"};
  };
  EXPECT_EQ("bag_file: x\nworld: y\nrobot_list: []\n",
            editYaml("bag_file: x\nrobot_list: []\n", "s.yaml", {{{"world"}, Value("y")}}, order));
}

TEST(YamlEdit, ChangesAliasedValuesAtTheirPlaceAlone) {
  const std::string text =
      "one:\n  points: &points\n    - [1, 2]  # hub\n    - [3, 4]\ntwo:\n  points: *points\n";
  EXPECT_EQ(
      "one:\n  points: &points\n    - [1, 5]  # hub\n    - [3, 4]\ntwo:\n  points:\n    - [1, 2]\n"
      "    - [3, 4]\n",
      set(text, {"one", "points", 0U, 1U}, 5));
  EXPECT_EQ(
      "one:\n  points: &points\n    - [1, 2]  # hub\n    - [3, 4]\ntwo:\n  points:\n    - [1, 5]\n"
      "    - [3, 4]\n",
      set(text, {"two", "points", 0U, 1U}, 5));
}

TEST(YamlEdit, KeepsWindowsLineEnds) {
  EXPECT_EQ("a: 1\r\ngroup:\r\n  b: 3  # two\r\n  c: [4, 5]\r\n",
            editYaml("a: 1\r\ngroup:\r\n  b: 2  # two\r\n", "s.yaml",
                     {{{"group", "b"}, Value(3)},
                      {{"group", "c"}, Value(Value::List{Value(4), Value(5)})}},
                     {}));
}

TEST(YamlEdit, TakesOneEntryOutOfAListAndKeepsTheOthersComments) {
  const std::string text =
      "list:\n  - a  # first\n  - b  # second\n  - c  # third\nflow: [1, 2, 3]\n";
  EXPECT_EQ("list:\n  - a  # first\n  - c  # third\nflow: [1, 2, 3]\n",
            set(text, {"list"}, Value::List{Value("a"), Value("c")}));
  EXPECT_EQ("list:\n  - a  # first\n  - b  # second\n  - c  # third\nflow: [1, 3]\n",
            removed(text, {"flow", 1U}));
}

TEST(YamlEdit, SaysPlainlyWhatCannotBeChanged) {
  const auto messages = test::messagesOf([] { (void)set("- a list\n", {"a"}, 1); });
  ASSERT_EQ(1U, messages.size());
  EXPECT_EQ("settings.yaml: found a list; it should be a group of named values", messages[0]);
}

class OddYaml : public testing::TestWithParam<std::string> {};

TEST_P(OddYaml, TakesEveryEdit) { expectEveryEditExact(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Texts, OddYaml,
    testing::Values(
        "a: &x {k: 1, l: [2, 3]}\nb: *x\nc:\n  - *x\n  - d: *x\n",
        "{a: 1, b: [1, {c: 2}, 'it''s'], \"d\": {e: f}}\n",
        "{\n  \"a\": 1,\n  \"b\": [\n    1,  # one\n    2   # two\n  ]\n}\n",
        "text: |\n  line one\n    deeper\n\n  line three\nnext: >-\n  folded\n  text\n\n# "
        "end\nlast: 1\n",
        "plain: several words\n  over two lines  # comment\nquoted: \"over\n  lines\"\nz: 1\n",
        "a: 1\n\n# between\n\nb:   2   # two\n  # odd comment\nc: 3\n",
        "a: 1\r\nb:\r\n  c: x  # y\r\n  d:\r\n  - 1\r\n  - 2\r\n# end\r\n",
        "a: 1\t# tab\nb:\t2\nc:\n  d: [1,\t2]\t#\ttabs\n", "a: 1\nb: 2\na: 3\n",
        "include: base.yaml\nyolo/main_list: list.txt\n/robot_list: [a, b]\n",
        "base: &base\n  a: 1\n  b: 2\nnext:\n  <<: *base\n  b: 3\n",
        "list:\n- a: 1\n  b: 2\n-   c: 3\n- - x\n  - y\n- [p, q]\n", "? explicit\n: 1\nplain: 2\n",
        "deep:\n      far:\n         - name: x   # n\n           type: y\n",
        "---\n# header\na: {b: 1}\n...\n",
        "\xEF\xBB\xBF"
        "a: 1\nb: 2\n",
        "u: \xC3\xA4\xC3\xB6 # \xC3\xBC\n\xC3\xA4: [\xC3\xB6, 1]\n",
        "tagged: !degrees 30\nnumber: !!float 3\nangle: deg(90)\nlist: !!seq [1]\n",
        "pairs: [a: 1, b: 2]\nempty: {}\nnone: []\ntext: ''\n",
        "a:\n  # first\n  b: 1\n  # last of a\n# of c\nc: 2"));

/// In lists of points, testing the first two numbers of the first two points is enough.
bool isLikeTheOneBefore(const YamlPath& path) {
  return std::any_of(path.begin(), path.end(), [](const YamlStep& step) {
    const auto* index = std::get_if<std::size_t>(&step);
    return index != nullptr && *index > 1;
  });
}

class ShippedSettings : public testing::TestWithParam<std::string> {};

TEST_P(ShippedSettings, TakeEveryEdit) {
  const std::string text = test::readFile(fs::path(test::sourceFolder()) / "config" / GetParam());
  const std::vector<std::string> comments = commentLines(text);
  const std::vector<std::string> lines = linesOf(text);
  const Value tree = readYamlText(text, "text");
  for (const YamlPath& path : pathsOf(text)) {
    if (isLikeTheOneBefore(path)) continue;
    expectText(text, path, std::nullopt);
    expectText(text, path, Value("another"));
    const Value* value = valueAt(tree, path);
    const bool is_scalar = !value->is<Value::List>() && !value->is<Value::Map>();
    const std::string edited = set(text, path, "another");
    if (!is_scalar || text.find("&rover") != std::string::npos) continue;
    EXPECT_EQ(comments, commentLines(edited)) << pathText(path);
    EXPECT_EQ(lines.size(), linesOf(edited).size()) << pathText(path);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, ShippedSettings,
                         testing::Values("example.yaml", "example_motions.yaml",
                                         "example_placement.yaml", "example_twin.yaml",
                                         "params.yaml", "randomize_default.yaml"));

/// One change after another, as in a long session, now and then a new setting or list entry: after
/// each, the text says exactly what was asked for.
class LongSession : public testing::TestWithParam<std::string> {};

TEST_P(LongSession, SaysWhatWasAskedForAllTheTime) {
  std::string text = test::readFile(fs::path(test::sourceFolder()) / "config" / GetParam());
  Value expected = readYamlText(text, "text");
  std::mt19937 random(7);  // NOLINT: the same session each time
  const std::vector<Value> values = {
      Value("word"),
      Value("two words # or: more"),
      Value(3),
      Value(-0.125),
      Value(false),
      Value(Value::List{Value(1.5), Value(2)}),
      Value(Value::Map{{"uniform", Value(Value::List{Value(0.5), Value(2.5)})}})};
  for (int i = 0; i < 120; ++i) {
    std::vector<YamlPath> paths;
    collectPaths(expected, {}, paths);
    if (paths.empty()) break;
    YamlPath path = paths[random() % paths.size()];
    std::optional<Value> value = values[random() % values.size()];
    const Value* there = valueAt(expected, path);
    const std::size_t what = random() % 4;
    if (what == 0) value.reset();
    if (what == 1 && there->is<Value::Map>()) path.emplace_back("new_" + std::to_string(i));
    if (what == 1 && there->is<Value::List>()) path.emplace_back(there->as<Value::List>()->size());
    if (value) {
      setValue(expected, path, *value);
    } else {
      expected = copyWith(expected, path, 0, value);
    }
    text = editYaml(text, "settings.yaml", {{path, value}}, {});
    ASSERT_TRUE(saysTheSame(expected, readYamlText(text, "text")))
        << i << ": " << pathText(path) << "\n"
        << text;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, LongSession,
                         testing::Values("example.yaml", "example_motions.yaml",
                                         "example_placement.yaml", "randomize_default.yaml"));

}  // namespace
}  // namespace synthetic_dataset::base
