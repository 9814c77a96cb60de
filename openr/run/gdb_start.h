// `openr run --gdb OBJECT`: starts gdb on a run, with breakpoints in the handlers of one object.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the handlers among `functions`, which are mangled names of functions of an image.
// Handlers are the methods of the object's class whose argument is an event, or the message of an
// entry that stub.cfg declares with Extra.  Each handler is written as gdb accepts it:
// "JointMover::ReadyEffector(OReadyEvent const&)".
std::vector<std::string> HandlersAmong(const std::vector<std::string>& functions);

// Returns the words of the command that starts gdb.  `printers` is a file that makes gdb show data
// of OPEN-R readably; "": no such file.  This command makes gdb read this file, stop at each of
// `handlers`, and run `program`, which is the command line of the run.
std::vector<std::string> GdbCommand(const std::vector<std::string>& handlers,
                                    const std::string& printers,
                                    const std::vector<std::string>& program);

// Replaces this process, whose arguments have --gdb `object`, by gdb. gdb runs the same command
// without --gdb.  The object is looked for on the stick in the folder `stick`.  Throws
// std::runtime_error if the stick has no such object or if gdb is missing.
[[noreturn]] void StartUnderGdb(const std::string& object, const std::string& stick);

}  // namespace openr_host
