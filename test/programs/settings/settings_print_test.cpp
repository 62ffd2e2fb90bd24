#include "programs/settings/settings_print.h"

#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::programs {
namespace settings_print_test {

TEST(SettingsYaml, ReadsBackAsItIs) {
  const Value settings = base::parseYaml(
      "{a: 1, b: 1.5, c: 'yes', d: [], e: {}, f: [1, [2, 3]], 'g: h': {\"i\\n\": \"'\"}, "
      "j: [{k: a text that is long enough to need a line of its own, l: [1, 2, 3, 4, 5, 6, 7, 8]}, "
      "{m: {n: a text that is long enough to need a line of its own, o: 1e-300, p: true}}]}",
      "given");
  EXPECT_EQ(base::parseYaml(settingsYaml(settings), "printed"), settings);
}

TEST(SettingsYaml, HasALineForWhatIsSmall) {
  EXPECT_EQ(settingsYaml(base::parseYaml("{world: {file: a.sdf}, scenes: 3}", "given")),
            "\"scenes\": 3\n\"world\": {\"file\": \"a.sdf\"}\n");
}

}  // namespace settings_print_test
}  // namespace synthetic_dataset::programs
