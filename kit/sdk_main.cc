// The program openr-sdk, which does the work of all tools of the SDK tree.  The tools are links to
// this program, which acts as the tool by whose name it was called.
//
//   mipsel-linux-g++ -O2 -c a.cc      the same as      openr-sdk g++ -O2 -c a.cc
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "kit/sdk_tools.h"

namespace openr_host {
namespace {

constexpr char kUsage[] =
    "usage: openr-sdk TOOL ARGUMENTS...\n"
    "  g++, gcc          compile for the host what was written for the robot\n"
    "  mkbin             link an image: -o X.bin X.ocf a.o libb.a ...\n"
    "  gzcp FROM TO      compressed copy\n"
    "  strip, gensnap    do nothing\n"
    "  ar, ld, nm, ...   the host's\n"
    "  image-info OCF OUT    the source of an image's description, for build systems\n"
    "  controller-main NM OUT [OBJECT...]    the source that calls a controller's main()\n";

// Returns the name of the tool in the path `program`: "g++" for "/sdk/bin/mipsel-linux-g++".
std::string ToolName(const std::string& program) {
  const std::string name = program.substr(program.rfind('/') + 1);
  const std::string target = "-linux-";
  const size_t at = name.find(target);
  return at == std::string::npos ? name : name.substr(at + target.size());
}

int RunTool(const std::string& tool, const Arguments& arguments) {
  if (tool == "g++" || tool == "c++") return RunCompiler(arguments, true);
  if (tool == "gcc" || tool == "cc") return RunCompiler(arguments, false);
  if (tool == "mkbin") return RunMkbin(arguments);
  if (tool == "gzcp") return RunGzcp(arguments);
  if (tool == "strip") return RunStrip(arguments);
  if (tool == "gensnap") return 0;
  if (tool == "image-info") return RunImageInfo(arguments);
  if (tool == "controller-main") return RunControllerMain(arguments);
  return RunHostTool(tool, arguments);
}

int Main(int argc, char** argv) {
  std::string tool = ToolName(argv[0]);
  int first = 1;
  if (tool == "openr-sdk") {
    if (argc < 2 || argv[1][0] == '-') {
      std::fputs(kUsage, argc < 2 ? stderr : stdout);
      return argc < 2 ? 2 : 0;
    }
    tool = ToolName(argv[1]);
    first = 2;
  }
  try {
    return RunTool(tool, Arguments(argv + first, argv + argc));
  } catch (const std::exception& error) {
    PrintPlain(stderr, "{}: {}\n", tool, error.what());
    return 1;
  }
}

}  // namespace
}  // namespace openr_host

int main(int argc, char** argv) {
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::Main(argc, argv), "openr-sdk");
}
