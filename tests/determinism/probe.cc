// hash_probe: one run of the whole graph without the command line around it.  Built by each
// compiler whose hashes are compared (check_hashes.sh); the program itself takes much longer to
// build.
//
//   hash_probe BODY SECONDS SEED STICK     prints state hash and trace hash
//   hash_probe picture WORLD PLACE STICK   prints the hash of what a camera sees of a world, a file
//                                          of this repository (picture_hash.h)
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>

#include "openr/simulation/simulation.h"
#include "tests/determinism/picture_hash.h"

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
    options.body = argv[1];
    options.seed = std::strtoull(argv[3], nullptr, 10);
    options.stick = argv[4];
    options.writable_stick = false;
    options.host_network = false;
    options.console = [](std::string_view) {};
    openr_host::Simulation simulation(options);
    openr_host::System& system = simulation.system();
    system.Boot();
    system.RunFor(std::strtoll(argv[2], nullptr, 10) * 1'000'000);
    fmt::print("{:016x} {:016x}\n", system.state_hash(), system.trace_hash());
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "hash_probe: {}\n", error.what());
    return 1;
  }
}
