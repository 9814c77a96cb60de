#include "runtime/core/memory_map.h"

#include <cinttypes>
#include <cstring>

namespace openr_host {

MemoryMap::MemoryMap() : list_(std::fopen("/proc/self/maps", "re")) {}

MemoryMap::~MemoryMap() {
  if (list_ != nullptr) std::fclose(list_);
}

bool MemoryMap::Next(MappedRange* range) {
  char line[4352];  // room for the numbers that begin a line, and for a path of 4096 bytes
  while (list_ != nullptr && std::fgets(line, sizeof line, list_) != nullptr) {
    char rights[5] = "";
    if (std::sscanf(line, "%" SCNxPTR "-%" SCNxPTR " %4s", &range->begin, &range->end, rights) != 3)
      continue;
    range->is_private_data = std::strcmp(rights, "rw-p") == 0;
    range->is_main_stack = std::strstr(line, "[stack]") != nullptr;
    return true;
  }
  return false;
}

}  // namespace openr_host
