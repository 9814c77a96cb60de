// Joining two Memory Stick trees, and what a robot asks of the result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// OBJECT.CFG, CONNECT.CFG or DESIGNDB.CFG of a base and of an application in one: the base's lines
// before ours, in each part: before the first [design] and from there on.  A line that both have,
// whatever blanks it has, is kept once.
std::string MergeConfig(const std::string& base, const std::string& ours);

// Whether the Memory Stick of the robot can hold this name: up to eight characters, a dot, up to
// three.  "" or what is wrong.
std::string WhyNotShortName(const std::string& name);

// Files and folders below `folder` whose names the robot's stick cannot hold.
std::vector<Diagnostic> CheckNames(const std::filesystem::path& folder);

// A blank beside '=' hangs the boot of the robot; an unknown key does nothing.
std::vector<Diagnostic> CheckWlanConfig(const std::string& file, const std::string& text);

// What OBJECT.CFG of `stick` (which holds OPEN-R/) names and is not there, and whether something
// handles the pause button.
std::vector<Diagnostic> CheckObjectConfig(const std::filesystem::path& stick);

}  // namespace openr_host
