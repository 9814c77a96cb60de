// play_messages PAIRS HASHED MESSAGES
// play_messages about
//
// Plays one game of the message rows and nothing else, for ./dev bench --callgrind.  HASHED is 1
// with the trace hash, 0 without.  `about` prints what the number of instructions depends on.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/machine.h"
#include "bench/ping_pong.h"

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "about") {
    std::printf("%s, %s, %s\n", openr_host::CompilerName().c_str(),
                openr_host::CLibraryName().c_str(), openr_host::InstructionSet().c_str());
    return 0;
  }
  if (argc != 4) {
    std::fprintf(stderr, "usage: play_messages PAIRS HASHED(0|1) MESSAGES | about\n");
    return 2;
  }
  openr_host::PingPong game(std::atoi(argv[1]), 32, std::atoi(argv[2]) != 0);
  game.Run(std::atoll(argv[3]));
  return 0;
}
