// The tools of the SDK tree.  Each gets its arguments without its own name and returns its exit
// status; what it says goes to standard output and error, as a tool of the SDK would.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

using Arguments = std::vector<std::string>;

// mipsel-linux-g++ and -gcc: the host's compiler with the kit's flags.
int RunCompiler(const Arguments& arguments, bool is_cxx);

// mkbin -o X.bin X.ocf a.o libb.a -lObjectComm: a shared object that holds the text of the .ocf.
int RunMkbin(const Arguments& arguments);

// image-info OCF OUT: the source of that text, to be compiled and linked last.
int RunImageInfo(const Arguments& arguments);

// controller-main NM OUT [OBJECT...]: the source that calls main() of a controller, for build
// systems; see controller_main.h.
int RunControllerMain(const Arguments& arguments);

// gzcp FROM TO: a compressed copy.
int RunGzcp(const Arguments& arguments);

// strip [-o OUT] FILE...: changes nothing, so that a debugger finds lines on the host.
int RunStrip(const Arguments& arguments);

// ar, ld and others: the host's, without the flags for the robot's processor.
int RunHostTool(const std::string& tool, const Arguments& arguments);

}  // namespace openr_host
