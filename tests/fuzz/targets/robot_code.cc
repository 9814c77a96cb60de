// The fuzz target robot_code: images for the robot, in which openr emon looks for the code of a
// crash.
#include "openr/emon/robot_code.h"

#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::robot_code(std::string_view bytes) {
  try {
    RobotCode code("X.BIN", std::string(bytes));
    code.SetGp(0x30000000);
    // The code of a small image ends about 0x8000 bytes below gp.
    for (uint32_t address = 0x2fff7000; address < 0x2fff9000; address += 4) {
      code.IsAfterCall(address);
    }
    for (const uint32_t address : {0U, 0x2fff8054U, 0x30000000U, 0xfffffffcU}) {
      code.IsAfterCall(address);
      FuzzCheck(code.LookUp(address).function.empty(), "no name without a file of names");
    }
    return code.InFile(0x30000000) < 0x400000;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
