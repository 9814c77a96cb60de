#include "runtime/core/robot_fault.h"

namespace openr_host {
namespace {

char g_fault[256] = "";  // an array and not a std::string, because a signal handler reads it

}  // namespace

void StopAsTheRobotDoes(const std::string& what) {
  g_fault[what.copy(g_fault, sizeof g_fault - 1)] = 0;
  __builtin_trap();
}

const char* AnnouncedFault() { return g_fault; }

}  // namespace openr_host
