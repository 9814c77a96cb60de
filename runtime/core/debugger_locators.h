// The locators of the primitives, where the pretty printers of gdb (tools/gdb/openr_printers.py)
// find them.  They are text in memory and not the result of a function, because gdb 13 cannot call
// functions on processors with AMX, and no gdb can in a core file.
#pragma once

#include <string>

namespace openr_host {

// Keeps `lines` for the debugger, in place of the lines before: a line "NUMBER LOCATOR" for each
// primitive of a robot.
void SetLocatorsForDebugger(const std::string& lines);

}  // namespace openr_host
