// docs/inputs.md and the program's own list of inputs name the same inputs.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "openr/simulation/simulation.h"
#include "runtime/core/inputs.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Adds the beginnings of the inputs in `usage`, up to the first argument: "release SENSOR" and
// "release JOINT" for "release SENSOR|JOINT".
void AddBeginnings(const std::string& usage, std::set<std::string>* beginnings) {
  std::istringstream words(usage);
  std::string kind, argument;
  words >> kind >> argument;
  while (!argument.empty() && argument.back() == ',') argument.pop_back();
  if (argument.empty()) beginnings->insert(kind);
  std::istringstream choices(argument);
  for (std::string choice; std::getline(choices, choice, '|');)
    beginnings->insert(kind + " " + choice);
}

std::set<std::string> InputsOfTheProgram() {
  SimulationOptions options;
  options.body = "ideal";
  options.host_network = false;
  options.console = [](std::string_view) {};
  Simulation simulation(options);
  constexpr std::string_view kOr = ", or ";  // as in "press SENSOR, or press pause"
  std::set<std::string> beginnings;
  for (const Inputs::Kind* const kind : simulation.system().inputs().KindsOf(0)) {
    std::string usage = kind->usage;
    for (size_t at = 0; (at = usage.find(kOr)) != std::string::npos;) {
      AddBeginnings(usage.substr(0, at), &beginnings);
      usage.erase(0, at + kOr.size());
    }
    AddBeginnings(usage, &beginnings);
  }
  return beginnings;
}

// Returns the inputs in the first columns of the tables between "## Inputs of every robot" and "##
// Scripts".
std::set<std::string> InputsOfThePage() {
  std::ifstream page(OPENR_DOCS "/inputs.md");
  std::string line;
  while (std::getline(page, line) && line != "## Inputs of every robot") {
  }
  std::set<std::string> beginnings;
  while (std::getline(page, line) && line != "## Scripts") {
    if (!line.starts_with("| `")) continue;
    std::istringstream parts(line.substr(0, line.find(" | ", 1)));
    std::string part;
    for (int i = 0; std::getline(parts, part, '`'); ++i) {
      const bool is_code = i % 2 == 1;
      if (is_code && !part.starts_with('[')) AddBeginnings(part, &beginnings);
    }
  }
  return beginnings;
}

TEST(DocumentedInputsTest, ThePageAndTheProgramNameTheSameInputs) {
  const std::set<std::string> program = InputsOfTheProgram();
  EXPECT_GT(program.size(), 20u);
  EXPECT_EQ(InputsOfThePage(), program);
}

}  // namespace
}  // namespace openr_host
