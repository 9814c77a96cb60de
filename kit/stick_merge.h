// Merges two Memory Stick trees, and checks the result for the robot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// Merges the OBJECT.CFG, CONNECT.CFG or DESIGNDB.CFG of a base stick with `ours`, the same file of
// an application.  The lines before the first section, such as [ERS-210], are for all robots; a
// section is for one design of robot.  The result has first the lines for all robots and then the
// sections; in both, the lines of the base come first.  If both files have the same line for all
// robots, apart from blanks, the result has this line once.
std::string MergeConfig(const std::string& base, const std::string& ours);

// Returns the reason why a Memory Stick of the robot cannot have a file `name`; "" if it can.  A
// name has up to eight characters, a dot, and up to three characters.
std::string ShortNameProblem(const std::string& name);

// Returns an error for each file and folder below `folder` whose name the robot's stick cannot
// have.
std::vector<Diagnostic> CheckNames(const std::filesystem::path& folder);

// Checks a WLANCONF.TXT, the network settings.  A blank beside '=' is an error, because such a
// blank hangs the robot while it boots.  An unknown key is a warning, because it has no effect.
std::vector<Diagnostic> CheckWlanConfig(const std::string& file, const std::string& text);

// Checks that the images which OBJECT.CFG of `stick` names exist, and that an object handles the
// pause button.  `stick` is the folder that holds OPEN-R/.
std::vector<Diagnostic> CheckObjectConfig(const std::filesystem::path& stick);

}  // namespace openr_host
