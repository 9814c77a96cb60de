#include "kit/controller_objects.h"

#include <fmt/format.h>

#include <stdexcept>

#include "cli/print_plain.h"
#include "kit/controller_main.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

Arguments Joined(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Generates and compiles the function that calls main().  The text of this function depends on how
// the controller declares main().  Returns the object file; "" after printing an error.
std::string CompileCallOfMain(const Arguments& objects, const fs::path& folder,
                              const fs::path& scratch, const Arguments& flags) {
  const ControllerMain main = FindControllerMain("nm", {objects.begin(), objects.end()});
  if (!main.problem.empty()) {
    PrintPlain(stderr, "{}: {}\n", folder.string(), main.problem);
    return "";
  }
  const std::string source = scratch / "ControllerMain.cc", object = source + ".o";
  const std::string problem = WriteText(source, main.source);
  if (!problem.empty()) throw std::runtime_error(problem);
  const Arguments compile = Joined({"-O2", "-c", "-o", object, source}, flags);
  return RunCompiler(compile, true) == 0 ? object : "";
}

}  // namespace

std::optional<Arguments> CompileController(const std::vector<fs::path>& sources,
                                           const fs::path& folder, const fs::path& scratch,
                                           const Arguments& flags) {
  const fs::path include = fs::path(SdkRoot()) / "controller" / "include";
  Arguments objects;
  bool good = true;
  // Compiles the user's own files, and not copies of them, so that messages and a debugger name the
  // user's files.
  for (const fs::path& source : sources) {
    const std::string object = scratch / fmt::format("{}.o", objects.size());
    const Arguments compile =
        Joined({"-O2", "-Dmain=controller_main", "-I" + folder.string(), "-I" + include.string(),
                "-I" + (include / "device").string(), "-c", "-o", object, source.string()},
               flags);
    // Goes on after a source with errors, so that the user sees the errors of all sources at once.
    good = RunCompiler(compile, source.extension() != ".c") == 0 && good;
    objects.push_back(object);
  }
  if (!good) return std::nullopt;
  objects.push_back(CompileCallOfMain(objects, folder, scratch, flags));
  if (objects.back().empty()) return std::nullopt;
  return objects;
}

}  // namespace openr_host
