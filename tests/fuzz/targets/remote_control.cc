// The fuzz target remote_control: sessions of the remote control: nine clients, a stick, a robot.
#include <filesystem>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/remote_driver.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::remote_control(std::string_view bytes) {
  static FuzzStick stick;
  try {
    RemoteDriver(&stick).Run(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    const std::string folder = stick.root() + "/MS/OPEN-R/MW/";
    const bool has_uploaded = std::filesystem::exists(folder + "DATA/P/F0.MTN") &&
                              std::filesystem::exists(folder + "OBJS/CONTROLL.OLD");
    ReachFuzzState(stick.State());
    stick.Restore();
    return has_uploaded;
  } catch (const Violation& violation) {
    FuzzViolation(violation.what());
  }
}

}  // namespace openr_host
