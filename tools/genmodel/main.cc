// openr_genmodel: generates the robot constants of the objects from the robot models.
//
//   openr_genmodel DIR MODEL.json...
//
// Writes DIR/RobotConstants.h and DIR/RobotConstants.cc, with all models in one table, in the given
// order.  Leaves a file alone if its content would not change, so that the build does not compile
// it again.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "emit.h"
#include "robot_tables.h"
#include "virtualrobot/model/robot_model.h"

namespace {

void WriteIfChanged(const std::filesystem::path& path, const std::string& text) {
  std::ostringstream old;
  old << std::ifstream(path).rdbuf();
  if (old.str() == text) return;
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw std::runtime_error(fmt::format("cannot write {}", path.string()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: openr_genmodel DIR MODEL.json...\n");
    return 2;
  }
  const std::filesystem::path directory = argv[1];
  const std::vector<std::string> paths(argv + 2, argv + argc);
  try {
    std::vector<openr_host::genmodel::RobotTables> robots;
    for (const std::string& path : paths)
      robots.push_back(openr_host::genmodel::TablesOf(openr_host::LoadRobotModel(path)));
    std::filesystem::create_directories(directory);
    WriteIfChanged(directory / "RobotConstants.h", openr_host::genmodel::HeaderText(robots));
    WriteIfChanged(directory / "RobotConstants.cc", openr_host::genmodel::SourceText(robots));
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr_genmodel: {}\n", error.what());
    return 1;
  }
  return 0;
}
