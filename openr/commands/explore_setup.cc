#include "openr/commands/explore_setup.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/exit_code.h"
#include "cli/growing_file.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "openr/simulation/cost_file.h"
#include "openr/simulation/sanitizer_start.h"

namespace openr_host {

SharedConsole::SharedConsole(const std::string& file) : file_(file) {
  if (file.empty()) return;
  std::string problem;
  descriptor_ = OpenGrowingFile(file, &problem);
  if (descriptor_ < 0) throw std::runtime_error(problem);
  error_ = static_cast<int*>(
      mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (error_ == MAP_FAILED) throw std::bad_alloc();
  fcntl(descriptor_, F_SETFL, O_APPEND);
}

SharedConsole::~SharedConsole() {
  if (descriptor_ < 0) return;
  munmap(error_, sizeof(int));
  close(descriptor_);
}

void SharedConsole::Print(std::string_view text) const {
  if (descriptor_ < 0 || *error_ != 0) return;
  *error_ = WriteAll(descriptor_, text);
}

std::string SharedConsole::Problem() const {
  return descriptor_ < 0 || *error_ == 0 ? "" : WriteErrorText(file_, *error_);
}

int WithConsole(int exit_code, const SharedConsole& console) {
  const std::string problem = console.Problem();
  if (problem.empty()) return exit_code;
  PrintPlain(stderr, "openr explore: {}\n", problem);
  return kExitWrong;
}

void StartWithSanitizersOf(const SimulationOptions& simulation) {
  StartWithSanitizerOf(simulation.stick);
  for (const std::string& stick : simulation.more_sticks) StartWithSanitizerOf(stick);
}

void SetStick(const ExploredStick& stick, const SharedConsole& console, ExplorePlan* plan) {
  // Loads the cost file here only to report an error in it once.  The processes of the exploration
  // load the cost file again later, and each of them would report the error.
  LoadCostFile(stick.simulation.cost_file);
  plan->run.for_us = stick.for_us;
  plan->run.properties.names = stick.properties;
  plan->run.properties.Make();
  SimulationOptions simulation = stick.simulation;
  simulation.console = [&console](std::string_view text) { console.Print(text); };
  plan->prepare_run = [simulation] { return PrepareSimulation(simulation); };
}

void PrintResult(const nlohmann::ordered_json& result, const std::string& text, bool as_json) {
  if (as_json) fmt::print("{}\n", JsonText(result));
  PrintPlain(as_json ? stderr : stdout, "{}", text);
}

}  // namespace openr_host
