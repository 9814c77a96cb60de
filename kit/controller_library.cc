#include "kit/controller_library.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/controller_objects.h"
#include "kit/controller_sources.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The source of a function that calls main() of the controller.  Only this function has default
// visibility, so the library exports no other function.
constexpr char kExport[] =
    "// Generated when the controller was built.\n\n"
    "int CallControllerMain();\n\n"
    "extern \"C\" __attribute__((visibility(\"default\"))) int\n{}()\n{{\n"
    "    return CallControllerMain();\n}}\n";

std::vector<fs::path> SourcesOf(const std::string& source) {
  std::error_code error;
  if (fs::is_regular_file(source, error)) return {fs::canonical(source)};
  if (!fs::is_directory(source, error)) {
    throw std::runtime_error(fmt::format(
        "{}: is neither a folder nor a file; name the controller's folder, or its one source",
        source));
  }
  const ControllerSources found = FindControllerSources(fs::canonical(source));
  std::fputs(Render(found.diagnostics).c_str(), stderr);
  if (HasErrors(found.diagnostics)) throw std::runtime_error(source + ": not built");
  if (found.files.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: has no source to run; 'openr controller new' makes a controller to begin with",
        source));
  }
  return found.files;
}

}  // namespace

std::string FolderOfController(const std::string& source) {
  std::error_code error;
  const fs::path whole = fs::absolute(source);
  return fs::is_directory(whole, error) ? whole : whole.parent_path();
}

bool BuildControllerLibrary(const ControllerLibraryOptions& options) {
  const fs::path scratch = fs::path(options.output).parent_path();
  const std::string folder = FolderOfController(options.source);
  // Compiles without the sanitizer checks for operations that stop the robot's processor.  The
  // functions that these checks call need a running OPEN-R object, and a controller library runs
  // outside of any object.
  const Arguments flags = {"-fno-sanitize=all"};
  const auto objects = CompileController(SourcesOf(options.source), folder, scratch, flags);
  if (!objects) return false;
  const std::string source = scratch / "ControllerExport.cc", object = source + ".o";
  const std::string problem = WriteText(source, fmt::format(kExport, kControllerMainName));
  if (!problem.empty()) throw std::runtime_error(problem);
  if (RunCompiler({"-O2", "-c", "-o", object, source}, true) != 0) return false;
  Arguments link = HostCompiler(Language::kCxx);
  link.insert(link.end(), {"-shared", "-o", options.output});
  link.insert(link.end(), objects->begin(), objects->end());
  link.insert(link.end(),
              {object, options.device_library, "-lm", "-Wl,-Bsymbolic", "-Wl,--no-undefined"});
  const ProcessResult linked = RunProcess(link);
  if (!linked.start_error.empty()) PrintPlain(stderr, "{}: {}\n", link[0], linked.start_error);
  return linked.good();
}

}  // namespace openr_host
