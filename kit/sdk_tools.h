// The tools of the SDK tree.  Each function takes the arguments of the tool without the tool's
// name, prints messages as the SDK's tool does, and returns the exit status.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

using Arguments = std::vector<std::string>;

// mipsel-linux-g++ and mipsel-linux-gcc: runs the host's compiler with the kit's flags.
int RunCompiler(const Arguments& arguments, bool is_cxx);

// mkbin -o X.bin X.ocf a.o libb.a -lObjectComm: links an image, a shared library that also contains
// the text of the .ocf file.
int RunMkbin(const Arguments& arguments);

// image-info OCF OUT: writes to OUT the source that brings the text of the .ocf file into an image.
// A build system compiles this source and links it into the image.
int RunImageInfo(const Arguments& arguments);

// controller-main NM OUT [OBJECT...]: writes the source that calls main() of a controller, for
// build systems; see controller_main.h.
int RunControllerMain(const Arguments& arguments);

// gzcp FROM TO: makes a copy of FROM that is compressed with gzip.
int RunGzcp(const Arguments& arguments);

// strip [-o OUT] FILE...: removes nothing, because a debugger on the host needs the debug
// information in the files.  With -o, copies the file.
int RunStrip(const Arguments& arguments);

// ar, ld and others: runs the host's tool, without the flags for the robot's processor.
int RunHostTool(const std::string& tool, const Arguments& arguments);

}  // namespace openr_host
