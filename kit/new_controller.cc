#include "kit/new_controller.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>

#include "kit/sdk_paths.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

constexpr char kTemplate[] = R"(/*
 * {}: blinks the mode indicator on the head.
 */

#include <device/led.h>
#include <device/robot.h>

#define TIME_STEP 64 /* ms, a multiple of 8 */

static DeviceTag mode;
static int step;

/* Called once, when the dog has stood up. */
static void
reset(void)
{{
    mode = robot_get_device("PRM:/r1/c1/c2/c3/l7-LED2:l7");
}}

/* Called again and again; returns how long it is until the next time. */
static int
run(int ms)
{{
    (void)ms; /* always 0 */
    led_set(mode, step / 8 % 2 == 0);
    step++;
    return TIME_STEP;
}}

int
main(void)
{{
    robot_live(reset);
    robot_run(run);
    return 0;
}}
)";

}  // namespace

std::string ControllerNameProblem(const std::string& name) {
  bool is_word = !name.empty();
  for (const char c : name)
    is_word = is_word && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_');
  if (is_word) return "";
  return fmt::format("'{}' cannot be the name of a controller: letters, digits and '_'", name);
}

std::vector<NewFile> MakeNewController(const std::string& name) {
  const std::string makefile = SdkRoot() + "/controller/Makefile.openr";
  const std::optional<std::string> text = ReadText(makefile);
  if (!text) throw std::runtime_error(makefile + " is missing; it belongs to the program");
  return {{name + ".c", fmt::format(kTemplate, name)},
          {"Makefile.sources",
           fmt::format("# The sources of the controller, C and C++.\nSOURCES = {}.c\n", name)},
          {"Makefile.openr", *text}};
}

}  // namespace openr_host
