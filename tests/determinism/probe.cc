// hash_probe: one run of the whole graph without the command line around it.  Built by each
// compiler whose hashes are compared (check_hashes.sh); the program itself takes much longer to
// build.
//
//   hash_probe BODY SECONDS SEED STICK     prints state hash and trace hash
//   hash_probe field SECONDS SEED STICK    the same for eight dogs together on the field of 2004,
//   and
//                                          the hash of what their cameras see at the end
//   hash_probe picture WORLD PLACE STICK   prints the hash of what a camera sees of a world, a file
//                                          of this repository (picture_hash.h)
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "tests/determinism/picture_hash.h"

namespace {

// Returns the hash of what the cameras of all robots see.
uint64_t HashOfCameras(const openr_host::Simulation& simulation) {
  openr_host::Hasher hasher;
  for (openr_host::VirtualRobot* const robot : simulation.robots()) {
    openr_host::Picture picture;
    const std::string problem = robot->CopyPicture(&picture);
    if (!problem.empty()) throw std::runtime_error(problem);
    hasher.AddBytes(picture.rgb.data(), picture.rgb.size());
  }
  return hasher.Digest();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: hash_probe BODY SECONDS SEED STICK, or picture WORLD PLACE STICK\n");
    return 2;
  }
  try {
    if (std::string_view(argv[1]) == "picture") {
      const std::string world = std::string(OPENR_SOURCE_DIR "/") + argv[2];
      fmt::print("{:016x}\n", openr_host::HashOfPicture(world, argv[3]));
      return 0;
    }
    openr_host::SimulationOptions options;
    const bool is_field = std::string_view(argv[1]) == "field";
    if (is_field) {
      options.world = OPENR_SOURCE_DIR "/virtualrobot/worlds/field-2004.json";
      options.robots = 8;
      options.together = true;
    } else {
      options.body = argv[1];
    }
    options.seed = std::strtoull(argv[3], nullptr, 10);
    options.stick = argv[4];
    options.writable_stick = false;
    options.host_network = false;
    options.console = [](std::string_view) {};
    openr_host::Simulation simulation(options);
    openr_host::System& system = simulation.system();
    system.Boot();
    system.RunFor(std::strtoll(argv[2], nullptr, 10) * 1'000'000);
    fmt::print("{:016x} {:016x}", system.state_hash(), system.trace_hash());
    if (is_field) fmt::print(" {:016x}", HashOfCameras(simulation));
    fmt::print("\n");
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "hash_probe: {}\n", error.what());
    return 1;
  }
}
