// The tools of the SDK tree.  Each function takes the arguments of the tool without the tool's
// name, prints messages as the SDK's tool does, and returns the exit status.
#pragma once

#include <string>
#include <vector>

#include "kit/sdk_paths.h"

namespace openr_host {

using Arguments = std::vector<std::string>;

// Runs mipsel-linux-g++ (`is_cxx`) or mipsel-linux-gcc: calls the host's compiler with the flags
// that old sources need.
int RunCompiler(const Arguments& arguments, bool is_cxx);

// Runs the tool `mkbin -o X.bin X.ocf a.o libb.a -lObjectComm`, which links an image.  An image is
// a shared library that also contains the text of the .ocf file.
int RunMkbin(const Arguments& arguments);

// Runs the tool `image-info OCF OUT`, which writes to OUT the source that brings the text of the
// .ocf file into an image.  A build system compiles this source and links it into the image.
int RunImageInfo(const Arguments& arguments);

// Runs the tool `controller-main NM OUT [OBJECT...]`, which writes to OUT the source that calls
// main() of a controller.  With NM, a program that lists symbols, the tool looks for main() in the
// object files OBJECT.  The tool is for build systems; see controller_main.h.
int RunControllerMain(const Arguments& arguments);

// Runs the tool `gzcp FROM TO`, which makes a copy of FROM that is compressed with gzip.
int RunGzcp(const Arguments& arguments);

// Runs the tool `strip [-o OUT] FILE...`, which removes nothing, because a debugger on the host
// needs the debug information in the files.  With -o, the tool copies the file.
int RunStrip(const Arguments& arguments);

// Does the work of the SDK's ar, ld and other tools: runs the host's tool of the name `tool` with
// `arguments`, without the flags for the robot's processor.
int RunHostTool(const std::string& tool, const Arguments& arguments);

}  // namespace openr_host
