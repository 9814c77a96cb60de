// The tool mkbin for the host: links the image of an object.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>

#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/build_variant.h"
#include "kit/foreign_code.h"
#include "kit/image_source.h"
#include "kit/kit_log.h"
#include "kit/link_command.h"
#include "kit/sdk_tools.h"
#include "kit/source_copies.h"
#include "runtime/base/read_file.h"
#include "runtime/config/ocf.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

int Refuse(const std::string& why) {
  PrintPlain(stderr, "mkbin: {}\n", why);
  return 1;
}

// Returns whether `command` links an object file or a library for another processor, and reports
// the first such file.  An object file for the robot comes from an earlier build.  make takes it
// for up to date and does not make it again, so the error tells the user to remove the file.  A
// library for the robot must be built again from its sources.
bool HasForeignCode(const LinkCommand& command) {
  for (const std::string& file : command.objects) {
    const std::string processor = ForeignProcessorOf(file);
    if (processor.empty()) continue;
    const std::string why =
        fmt::format("was compiled for another processor ({}); remove it (make clean)", processor);
    LogFailure({file, why, command.output});
    Refuse(fmt::format("{} {} and build again", file, why));
    return true;
  }
  for (const std::string& file : command.libraries) {
    const std::string processor = ForeignProcessorOf(file);
    if (processor.empty()) continue;
    const std::string why = fmt::format(
        "is a library for another processor ({}); build it for this machine from its sources",
        processor);
    LogFailure({file, why, command.output});
    Refuse(fmt::format("{} {}", file, why));
    return true;
  }
  return false;
}

// Returns the path of the image `output` without its extension.  The names of intermediate files
// begin with this path, so that they are the same names as with the SDK's mkbin.
std::string Stem(const std::string& output) {
  return (fs::path(output).parent_path() / fs::path(output).stem()).string();
}

// Compiles the source that brings the text of the .ocf file into the image.  Returns the object
// file, or "" after printing an error.
std::string CompileImageInfo(const LinkCommand& command, const std::string& ocf_text) {
  const std::string source = Stem(command.output) + ".snap.c";
  const std::string object = Stem(command.output) + ".snap.o";
  const std::string problem = WriteFile(source, MakeImageSource(ocf_text));
  if (!problem.empty()) {
    Refuse(problem);
    return "";
  }
  Arguments compile = HostCompiler(Language::kC);
  compile.insert(compile.end(), {"-x", "c", "-O1", "-fPIC", "-c", "-o", object, source});
  const ProcessResult result = RunProcess(compile);
  std::error_code ignored;
  fs::remove(source, ignored);
  if (!result.start_error.empty()) Refuse(result.start_error);
  return result.good() ? object : "";
}

// Returns the path of the file that the linker writes.  mkbin copies this file to the image only if
// the linker succeeds, so that no incomplete image ever exists.
std::string LinkedFile(const LinkCommand& command) { return Stem(command.output) + ".nosnap.elf"; }

Arguments LinkArguments(const LinkCommand& command, const std::string& image_info) {
  const fs::path prefix = fs::path(SdkRoot()).parent_path().parent_path().parent_path();
  Arguments link = HostCompiler(Language::kCxx);
  link.insert(link.end(), {"-shared", "-o", LinkedFile(command)});
  link.insert(link.end(), command.objects.begin(), command.objects.end());
  // Links the libraries as a group, so that each may use functions of all other libraries.
  link.push_back("-Wl,--start-group");
  link.insert(link.end(), command.libraries.begin(), command.libraries.end());
  link.insert(link.end(), {"-Wl,--end-group", image_info, "-L" + (prefix / "lib").string(),
                           "-L" + (prefix / "lib/openr-host").string(), "-lopenr_runtime", "-lm",
                           "-Wl,-Bsymbolic", "-Wl,--no-undefined"});
  if (!command.map.empty()) link.push_back("-Wl,-Map=" + command.map);
  const Arguments variant = VariantLinkFlags(VariantOfBuild());
  link.insert(link.end(), variant.begin(), variant.end());
  return link;
}

// Returns the linker's messages `output` without warnings about dangerous functions such as gets(),
// because the runtime gives objects safe versions of these functions.
std::string WithoutDangerWarnings(const std::string& output) {
  std::istringstream lines(output);
  std::string kept, last;
  for (std::string line; std::getline(lines, line);) {
    const bool is_danger = line.find("is dangerous") != std::string::npos;
    if (!is_danger && !last.empty()) kept += last + "\n";
    last = is_danger ? "" : line;
    // Holds back a line such as "in function `main'", because it is to be dropped if the next line
    // is a warning like "the `gets' function is dangerous".
    if (line.find(": in function `") == std::string::npos && !last.empty()) {
      kept += last + "\n";
      last.clear();
    }
  }
  return last.empty() ? kept : kept + last + "\n";
}

// Makes hard links to the linked file, under the names of the intermediate files that the SDK's
// mkbin leaves, because rules of Makefiles use files of these names.
void LinkIntermediates(const LinkCommand& command) {
  std::error_code ignored;
  for (const char* extension : {".snap.elf", ".rel.elf"}) {
    fs::remove(Stem(command.output) + extension, ignored);
    fs::create_hard_link(LinkedFile(command), Stem(command.output) + extension, ignored);
  }
}

// Returns a summary in one line of `output`, the linker's errors.
std::string Summarise(const std::string& output) {
  const std::vector<std::string> names = UndefinedNames(output);
  if (names.empty()) return "does not link";
  constexpr size_t kShown = 3;
  const std::vector<std::string> first(names.begin(),
                                       names.begin() + std::min(names.size(), kShown));
  return fmt::format("{} undefined: {}{}; is a source or a library missing?",
                     names.size() == 1 ? "is" : fmt::format("{} names are", names.size()),
                     fmt::join(first, ", "), names.size() > kShown ? ", ..." : "");
}

// Returns the path by which the user knows `file`: the path of the original if `openr build` has
// made `file` in a private copy of the user's folder, else `file`.
std::string NameForUser(const std::string& file) {
  const std::string original =
      OriginalOf(fs::absolute(file).lexically_normal().string(), SourceCopies());
  return original.empty() ? file : original;
}

}  // namespace

int RunMkbin(const Arguments& arguments) {
  const LinkCommand command =
      TranslateMkbin(arguments, [](const std::string& file) { return fs::exists(file); });
  if (command.output.empty()) return Refuse("no output; write -o NAME.bin");
  if (command.ocf.empty()) return Refuse("no .ocf file among the arguments");
  const std::optional<std::string> ocf_text = ReadFile(command.ocf);
  if (!ocf_text)
    return Refuse(fmt::format("{}: cannot be read: {}", command.ocf, std::strerror(errno)));
  const OcfResult ocf = ParseOcf(NameForUser(command.ocf), *ocf_text);
  std::fputs(Render(ocf.diagnostics).c_str(), stderr);
  if (!ocf.ocf) {
    LogFailure({command.ocf, "is not a good .ocf file", command.output});
    return 1;
  }
  // Looks for code for another processor before linking, because the linker's own message does not
  // say what to do.
  if (HasForeignCode(command)) return 1;
  const std::string image_info = CompileImageInfo(command, *ocf_text);
  if (image_info.empty()) return 1;
  const Arguments link = LinkArguments(command, image_info);
  if (command.is_verbose) PrintPlain(stderr, "{}\n", fmt::join(link, " "));
  // Sets the language of messages to English, because the linker's output is parsed.
  const ProcessResult result =
      RunProcess(link, {.environment = {{"LC_ALL", "C"}}, .captures_error = true});
  std::fputs(WithoutDangerWarnings(result.output).c_str(), stderr);
  if (!result.good()) {
    if (!result.start_error.empty()) Refuse(result.start_error);
    LogFailure({command.output, Summarise(result.output), command.output});
    return result.status;
  }
  const std::string problem = CopyToFile(LinkedFile(command), command.output);
  if (!problem.empty()) {
    LogFailure({command.output, "cannot be written", command.output});
    return Refuse(problem);
  }
  LinkIntermediates(command);
  Arguments parts = command.objects;
  parts.insert(parts.end(), command.libraries.begin(), command.libraries.end());
  LogImage({command.output, ocf.ocf->name, command.ocf, parts});
  return 0;
}

int RunImageInfo(const Arguments& arguments) {
  if (arguments.size() != 2) {
    std::fputs("usage: openr-sdk image-info OCF OUT\n", stderr);
    return 2;
  }
  const std::optional<std::string> text = ReadFile(arguments[0]);
  if (!text) {
    PrintPlain(stderr, "{}: cannot be read: {}\n", arguments[0], std::strerror(errno));
    return 1;
  }
  const OcfResult ocf = ParseOcf(arguments[0], *text);
  std::fputs(Render(ocf.diagnostics).c_str(), stderr);
  if (!ocf.ocf) return 1;
  const std::string problem = WriteFile(arguments[1], MakeImageSource(*text));
  if (problem.empty()) return 0;
  PrintPlain(stderr, "{}\n", problem);
  return 1;
}

}  // namespace openr_host
