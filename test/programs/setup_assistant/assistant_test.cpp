#include "programs/setup_assistant/assistant.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/json_text.h"
#include "base/yaml_text/yaml_rendering.h"
#include "output/manifest/manifest_schema.h"
#include "run/generator.h"
#include "support/temporary_folder.h"
#include "support/tiny_run.h"

namespace synthetic_dataset::programs {
namespace {

/// The setup assistant with a small run without problems.
class OpenAssistant {
 public:
  Value get(const std::string& path, const std::map<std::string, std::string>& query = {}) {
    HttpRequest request;
    request.method = "GET";
    request.path = path;
    request.query = query;
    return base::parseJson(assistant.answer(request).body, path);
  }

  Value post(const std::string& path, const Value& body) {
    HttpRequest request;
    request.method = "POST";
    request.path = path;
    request.body = base::strictJsonText(body);
    return base::parseJson(assistant.answer(request).body, path);
  }

  Value set(Value::List path, const Value& value) {
    const Value revision = memberOf(get("/api/state"), "revision");
    const Value change = Value::Map{{"path", Value(std::move(path))}, {"value", value}};
    return post("/api/set",
                Value::Map{{"revision", revision}, {"changes", Value(Value::List{change})}});
  }

  HttpResponse fetch(const std::string& path) {
    HttpRequest request;
    request.method = "GET";
    request.path = path;
    return assistant.answer(request);
  }

  [[nodiscard]] std::string onDisk() const { return test::readFile(file); }

  static Value memberOf(const Value& group, const std::string& name) {
    return group.as<Value::Map>()->at(name);
  }

  test::TinyRun run;
  std::filesystem::path file = run.folder().write(
      "settings.yaml", "# A small run.\n" + base::blockYaml(run.parameters(), 0, {}) + "\n");
  Assistant assistant{file.string(), {}, EmbeddedFiles()};
};

int statusOf(OpenAssistant& open, const std::string& method, const std::string& path,
             const std::string& body = "") {
  HttpRequest request;
  request.method = method;
  request.path = path;
  request.body = body;
  try {
    return open.assistant.answer(request).status;
  } catch (const HttpError& error) {
    return error.status();
  }
}

Value memberOf(const Value& group, const std::string& name) {
  return OpenAssistant::memberOf(group, name);
}

TEST(Assistant, ShowsTheSettingsAndChangesThemOnTheDisk) {
  OpenAssistant open;
  const Value state = open.get("/api/state");
  EXPECT_EQ(Value(open.file.string()), memberOf(state, "file"));
  EXPECT_EQ(Value(open.onDisk()), memberOf(state, "text"));
  const Value changed = open.set({Value("camera"), Value("far")}, 40.5);
  EXPECT_NE(std::string::npos, open.onDisk().find("far: 40.5"));
  EXPECT_EQ(0U, open.onDisk().find("# A small run.\n"));
  EXPECT_EQ(Value(true), memberOf(changed, "can_undo"));
  (void)open.post("/api/undo", Value::Map{});
  EXPECT_EQ(memberOf(state, "text"), Value(open.onDisk()));
}

TEST(Assistant, ShowsWhatTheRunWillMake) {
  OpenAssistant open;
  const Value setup = open.get("/api/setup");
  EXPECT_EQ(Value(true), memberOf(setup, "ready")) << base::jsonText(setup);
  const Value scene = open.get("/api/scene", {{"instant", "2"}});
  EXPECT_EQ(memberOf(open.get("/api/state"), "revision"), memberOf(scene, "revision"));
  const HttpResponse picture = open.fetch("/" + memberOf(scene, "picture").text());
  EXPECT_EQ("image/jpeg", picture.type);
  EXPECT_EQ("\xFF\xD8", picture.body.substr(0, 2));  // a JPEG's first marker
}

TEST(Assistant, GlancesFromACameraThatIsMoved) {
  OpenAssistant open;
  HttpRequest request;
  request.method = "GET";
  request.path = "/api/glance";
  request.query = {{"x", "-3"},   {"z", "1"},     {"qx", "-0.5"},
                   {"qy", "0.5"}, {"qz", "-0.5"}, {"qw", "0.5"}};
  const HttpResponse picture = open.assistant.answer(request);
  EXPECT_EQ("image/jpeg", picture.type);
  EXPECT_EQ("\xFF\xD8", picture.body.substr(0, 2));
  request.query["qw"] = "0";
  request.query["qx"] = request.query["qy"] = request.query["qz"] = "0";
  EXPECT_THROW((void)open.assistant.answer(request), HttpError);
}

TEST(Assistant, ShowsWhatTheFilesHold) {
  OpenAssistant open;
  EXPECT_FALSE(memberOf(open.get("/api/recording"), "frames").as<Value::List>()->empty());
  const Value world = open.get("/api/world");
  EXPECT_FALSE(memberOf(world, "models").as<Value::List>()->empty());
  EXPECT_EQ("image/png", open.fetch("/" + memberOf(world, "map").text()).type);
  const Value model = open.get("/api/model", {{"object", "alpha"}, {"width", "200"}});
  EXPECT_EQ("image/jpeg", open.fetch("/" + memberOf(model, "picture").text()).type);
  const Value draws = open.get("/api/draws", {{"count", "2"}});
  EXPECT_EQ(2U, memberOf(draws, "pictures").as<Value::List>()->size());
  EXPECT_EQ(404, statusOf(open, "GET", "/api/placement"));
}

TEST(Assistant, ReadsWhatAClickOnAModelMeans) {
  OpenAssistant open;
  Value::Map click = {{"object", Value("alpha")}, {"yaw", Value(0.0)}, {"pitch", Value(0.0)},
                      {"width", Value(200)},      {"x", Value(99.5)},  {"y", Value(74.5)}};
  const Value hit = open.post("/api/pick", click);
  const Value::List p = *memberOf(hit, "p").as<Value::List>();
  EXPECT_NEAR(0.2, *p[0].as<double>(), 1e-3);  // the box of 0.4 m, seen from its +x
  click["x"] = 1.0;
  EXPECT_TRUE(memberOf(open.post("/api/pick", click), "p").isNull());
}

TEST(Assistant, AnswersAllPagesThatAskAtTheSameTime) {
  OpenAssistant open;
  std::vector<std::future<int>> statuses;
  for (int page = 0; page < 8; ++page) {
    statuses.push_back(std::async(std::launch::async, [&open, page] {
      HttpRequest request;
      request.method = "GET";
      request.path = "/api/model";
      request.query = {{"object", "alpha"}, {"width", "64"}};
      request.headers["x-page"] = std::to_string(page);
      try {
        return open.assistant.answer(request).status;
      } catch (const HttpError& error) {
        return error.status();
      }
    }));
  }
  for (std::future<int>& status : statuses) EXPECT_EQ(200, status.get());
}

TEST(Assistant, ShowsEachProblemAtItsField) {
  OpenAssistant open;
  (void)open.set({Value("world")}, "no_such.world");
  const Value setup = open.get("/api/setup");
  EXPECT_EQ(Value(false), memberOf(setup, "ready"));
  const Value::List problems = *memberOf(setup, "problems").as<Value::List>();
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(Value(Value::List{Value("world")}), memberOf(problems.front(), "path"))
      << base::jsonText(setup);
}

TEST(Assistant, NoticesWhatSomebodyElseWrites) {
  OpenAssistant open;
  HttpRequest request;
  request.method = "GET";
  request.path = "/api/events";
  const auto events = open.assistant.answer(request).events;
  (void)events->next(std::chrono::seconds(30));  // the state at the start
  open.run.folder().write("settings.yaml", "seed: 7\n");
  EXPECT_EQ(409, statusOf(open, "POST", "/api/undo"));
  EXPECT_EQ(Value("seed: 7\n"), memberOf(memberOf(open.get("/api/state"), "outside"), "text"));
  (void)open.post("/api/outside", Value::Map{{"take", Value(true)}});
  EXPECT_EQ(Value("seed: 7\n"), memberOf(open.get("/api/state"), "text"));
}

TEST(Assistant, RefusesARunThatWritesElsewhere) {
  OpenAssistant open;
  test::TemporaryFolder elsewhere;
  (void)open.set({Value("output_folder")}, (elsewhere / "dataset").string());
  EXPECT_EQ(403, statusOf(open, "POST", "/api/run/start"));
  EXPECT_EQ(Value("idle"), memberOf(open.get("/api/run"), "state"));
}

TEST(Assistant, RefusesAListOfAWriterThatLiesElsewhere) {
  OpenAssistant open;
  for (const char* list : {"../../../list.txt", "/etc/list.txt", "../../other/../../list.txt"}) {
    (void)open.set({Value("yolo")}, Value::Map{{"main_list", Value(list)}});
    EXPECT_EQ(403, statusOf(open, "POST", "/api/run/start")) << list;
  }
  EXPECT_EQ(Value("idle"), memberOf(open.get("/api/run"), "state"));
}

TEST(Assistant, ShowsNoFileOrVariableThatTheUserHasNotNamed) {
  OpenAssistant open;
  test::TemporaryFolder elsewhere;
  elsewhere.write("key.yaml", "password: secret\n");
  ::setenv("SYNTHETIC_DATASET_TEST_KEY", "secret", 1);
  (void)open.set({Value("include")}, (elsewhere / "key.yaml").string());
  EXPECT_EQ(std::string::npos, base::jsonText(open.get("/api/state")).find("secret"));
  (void)open.set({Value("include")}, "../" + elsewhere.path().filename().string() + "/key.yaml");
  EXPECT_EQ(std::string::npos, base::jsonText(open.get("/api/state")).find("secret"));
  (void)open.post("/api/undo", Value::Map{});
  (void)open.post("/api/undo", Value::Map{});
  for (const char* text :
       {"$(env SYNTHETIC_DATASET_TEST_KEY)", "$(optenv SYNTHETIC_DATASET_TEST_KEY x)"}) {
    (void)open.set({Value("global_frame")}, text);
    const std::string state = base::jsonText(open.get("/api/state"));
    EXPECT_EQ(std::string::npos, state.find("secret"));
    EXPECT_NE(std::string::npos,
              base::jsonText(open.get("/api/setup")).find("SYNTHETIC_DATASET_TEST_KEY, which"));
  }
  // Someone who can start programs as this user may be shown it.
  Assistant again(open.file.string(), {}, EmbeddedFiles());
  HttpRequest request;
  request.method = "GET";
  request.path = "/api/state";
  EXPECT_NE(std::string::npos, again.answer(request).body.find("secret"));
}

TEST(Assistant, RefusesRequestsThatNestWithoutBound) {
  OpenAssistant open;
  const std::string deep = std::string(20000, '[') + std::string(20000, ']');
  EXPECT_EQ(400, statusOf(open, "POST", "/api/set", deep));
  EXPECT_EQ(400, statusOf(open, "POST", "/api/text", "{\"text\": " + deep + "}"));
}

TEST(Assistant, HasNoPageOfResultsBehindTheLast) {
  OpenAssistant open;
  run::Reporter silent;
  (void)run::Generator(Value(open.run.parameters()), silent).run();
  for (const char* page : {"400000000000000000", "-400000000000000000", "9223372036854775807"}) {
    const Value result = open.get("/api/result", {{"page", page}});
    const Value::List* scenes = memberOf(result, "scenes").as<Value::List>();
    EXPECT_EQ(page[0] != '-', scenes->empty()) << page;
  }
}

TEST(Assistant, FindsScenesByTheirLabels) {
  OpenAssistant open;
  run::Reporter silent;
  (void)run::Generator(Value(open.run.parameters()), silent).run();
  const auto numberOf = [](const Value& result) {
    return *memberOf(memberOf(result, "chosen"), "scene_count").as<std::int64_t>();
  };
  const Value all = open.get("/api/result");
  EXPECT_EQ(*memberOf(all, "scene_count").as<std::int64_t>(), numberOf(all));
  const Value classes = memberOf(memberOf(all, "chosen"), "classes");
  ASSERT_FALSE(classes.as<Value::Map>()->empty());
  const std::string name = classes.as<Value::Map>()->begin()->first;
  const Value of_class = open.get("/api/result", {{"class", name}});
  EXPECT_GT(numberOf(of_class), 0);
  EXPECT_EQ(1U, memberOf(memberOf(of_class, "chosen"), "classes").as<Value::Map>()->size());
  const Value none = open.get("/api/result", {{"class", "no such class"}});
  EXPECT_EQ(0, numberOf(none));
  EXPECT_TRUE(memberOf(none, "scenes").as<Value::List>()->empty());
  EXPECT_EQ(numberOf(all), *memberOf(none, "scene_count").as<std::int64_t>());
}

TEST(Assistant, ShowsAReportThatIsThere) {
  OpenAssistant open;
  run::Reporter silent;
  (void)run::Generator(Value(open.run.parameters()), silent).run();
  EXPECT_EQ(404, statusOf(open, "GET", "/api/report"));
  EXPECT_TRUE(memberOf(open.get("/api/result"), "report").isNull());
  const std::string folder = *memberOf(open.get("/api/result"), "folder").as<std::string>();
  std::ofstream(output::reportFile(folder)) << "<p>The report</p>";
  EXPECT_FALSE(memberOf(open.get("/api/result"), "report").isNull());
  const HttpResponse report = open.fetch("/api/report");
  EXPECT_EQ("<p>The report</p>", report.body);
  EXPECT_EQ(0U, report.headers.at("Content-Security-Policy").find("sandbox;"));
}

TEST(Assistant, SaysWhatItDoesNotHave) {
  OpenAssistant open;
  EXPECT_EQ(404, statusOf(open, "GET", "/api/no_such"));
  EXPECT_EQ(404, statusOf(open, "GET", "/page/../settings.yaml"));
  EXPECT_EQ(404, statusOf(open, "GET", "/api/picture/1.jpg"));
  EXPECT_EQ(404, statusOf(open, "GET", "/api/result"));
  EXPECT_EQ(400, statusOf(open, "POST", "/api/set", "{no JSON"));
  EXPECT_EQ(400, statusOf(open, "POST", "/api/set", "{}"));
}

}  // namespace
}  // namespace synthetic_dataset::programs
