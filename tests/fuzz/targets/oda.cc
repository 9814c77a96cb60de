// The fuzz target oda: ODA containers.
#include <set>
#include <stdexcept>

#include "openr/motion/oda_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::oda(std::string_view bytes) {
  try {
    std::set<std::string> files;
    size_t empty = 0;
    for (const OdaMember& member : ReadOda(bytes)) {
      FuzzCheck(files.insert(member.file).second, "files have different names");
      FuzzCheck(member.file.find('/') == std::string::npos, "a file leaves its folder");
      if (!member.bytes.empty()) {
        FuzzCheck(member.bytes.data() >= bytes.data() &&
                      member.bytes.data() + member.bytes.size() <= bytes.data() + bytes.size(),
                  "a member outside of the container");
      }
      empty += member.bytes.empty();
    }
    return files.size() > 1 && empty == 1;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host
