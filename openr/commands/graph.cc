// The command openr graph: shows the objects of a Memory Stick, their services and their
// connections.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "cli/colour.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/process.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/ending/end_guards.h"
#include "openr/graph/graph_view.h"
#include "openr/run/report.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/sanitizer_start.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int64_t kBootMaxUs = 60'000'000;

struct GraphFlags {
  SimulationOptions simulation;
  std::string format = "dot";
  std::string file;
  int64_t for_us = 0;
};

std::string Rendered(const GraphView& graph, const std::string& format) {
  if (format == "json") return JsonText(GraphToJson(graph), 2) + "\n";
  const std::string dot = GraphToDot(graph);
  if (format == "dot") return dot;
  const ProcessResult svg = RunProcess({"dot", "-Tsvg"}, {.captures_out = true, .input = dot});
  if (svg.good()) return svg.output;
  throw std::runtime_error("--format svg needs the program 'dot' (Debian package graphviz)");
}

void Write(const std::string& text, const std::string& name) {
  if (name.empty()) {
    PrintAnswer(text);
    return;
  }
  const std::string problem = WriteFile(name, text);
  if (!problem.empty()) throw std::runtime_error(problem);
}

// Runs `system` until the virtual time is `end_us`.  Shows the progress on a terminal.
void RunFor(System* system, int64_t end_us) {
  constexpr int64_t kSliceUs = 200'000;
  RunProgressLine progress(STDERR_FILENO, system->now_us(), end_us);
  for (int64_t time_us = system->now_us(); time_us < end_us;) {
    time_us = std::min(time_us + kSliceUs, end_us);
    system->RunUntil(time_us);
    progress.Show(time_us);
  }
}

int Graph(GraphFlags flags) {
  const Console console("");
  flags.simulation.console = [](std::string_view) {};  // discards the text that objects print
  flags.simulation.host_network = false;
  const RunStick stick(flags.simulation.stick, true);
  flags.simulation.stick = stick.folder();
  const EndGuards guards({.limit_name = ""});
  Simulation simulation(flags.simulation);
  System& system = simulation.system();
  bool booted = false;
  if (simulation.loaded()) {
    system.Boot();
    booted = system.RunUntil([&system] { return system.booted(); }, kBootMaxUs);
    if (booted) RunFor(&system, flags.for_us);
  }
  if (!booted) {
    fmt::print(stderr, "{}openr graph: the robot does not boot\n",
               DescribeFindings(&simulation, HasColours(STDERR_FILENO)));
    return kExitWrong;
  }
  fmt::print(stderr, "{}", DescribeFindings(&simulation, HasColours(STDERR_FILENO)));
  Write(Rendered(CollectGraph(&system), flags.format), flags.file);
  return system.findings().HasError() ? kExitWrong : kExitGood;
}

}  // namespace

void AddGraphCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("graph", "Objects, services and connections of a stick");
  auto flags = std::make_shared<GraphFlags>();
  AddCommonFlags(command, &flags->simulation);
  command->add_option("--format", flags->format, "dot, json or svg")
      ->check(CLI::IsMember({"dot", "json", "svg"}))
      ->capture_default_str();
  AddDurationFlag(command, "--for", &flags->for_us,
                  "Run for this virtual time first: shows states and counts of events");
  command->add_option("-o,--output", flags->file, "File to write (default: standard output)")
      ->check(IsWritable());
  command->callback([flags, exit_code] {
    StartWithSanitizerOf(flags->simulation.stick);
    *exit_code = Graph(*flags);
  });
}

}  // namespace openr_host
