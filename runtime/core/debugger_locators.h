// The locators of the primitives, for the pretty printers of gdb (tools/gdb/openr_printers.py). gdb
// reads them from memory and does not call a function to get them.  The reason is that gdb 13
// cannot call functions on processors with AMX, and no version of gdb can call functions in a core
// file.
#pragma once

#include <string>

namespace openr_host {

// Stores `lines` for the debugger: a line "NUMBER LOCATOR" for each primitive of a robot.  Replaces
// the lines of an earlier call.
void SetLocatorsForDebugger(const std::string& lines);

}  // namespace openr_host
