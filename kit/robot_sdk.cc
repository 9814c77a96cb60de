#include "kit/robot_sdk.h"

#include <elf.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The tools of Sony's SDK that RobotSdk runs; docs/openr/core.md, section 5.5, explains them.
constexpr const char* kTools[] = {"bin/mipsel-linux-g++", "bin/mipsel-linux-gcc",
                                  "OPEN_R/bin/stubgen2", "OPEN_R/bin/mkbin"};

}  // namespace

RobotSdk RobotSdk::FromEnvironment() {
  const char* const root = std::getenv("OPENRSDK_ROOT");
  if (root == nullptr || *root == '\0') {
    throw std::runtime_error(
        "OPENRSDK_ROOT is not set; it names the folder of the OPEN-R SDK, with bin/ and OPEN_R/ in "
        "it (the SDK's own default is /usr/local/OPEN_R_SDK)");
  }
  return RobotSdk(root);
}

RobotSdk::RobotSdk(const fs::path& root) : root_(fs::absolute(root).lexically_normal()) {
  std::error_code error;
  if (!fs::is_directory(root_, error)) {
    throw std::runtime_error(
        fmt::format("OPENRSDK_ROOT={}: there is no such folder", root.string()));
  }
  // Recognises our own SDK tree by a file that Sony's SDK does not have.
  if (fs::exists(root_ / "compile-flags.txt", error)) {
    throw std::runtime_error(fmt::format(
        "OPENRSDK_ROOT={} is openr-host's own tree, which makes images for this machine; for the "
        "robot it has to name Sony's OPEN-R SDK with its MIPS compiler",
        root.string()));
  }
  for (const char* tool : kTools) {
    if (access((root_ / tool).c_str(), X_OK) == 0) continue;
    throw std::runtime_error(
        fmt::format("{}: no such program; OPENRSDK_ROOT has to name an OPEN-R SDK with its "
                    "compiler installed",
                    (root_ / tool).string()));
  }
}

fs::path RobotSdk::BaseStick(const std::string& model, const std::string& flavour,
                             bool is_protected) const {
  const fs::path models = root_ / "OPEN_R" / model;
  const fs::path base = models / flavour / (is_protected ? "memprot" : "nomemprot");
  if (!FindEntry(base, "OPEN-R").empty()) return base;
  std::vector<std::string> known;
  std::error_code error;
  for (auto at = fs::recursive_directory_iterator(models, error);
       at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (LowerCase(at->path().filename()) == "open-r" && at->is_directory(error)) {
      known.push_back(at->path().parent_path().lexically_relative(models));
      at.disable_recursion_pending();
    }
  }
  std::sort(known.begin(), known.end());
  throw std::runtime_error(fmt::format(
      "{}: no OPEN-R/ in it, so it is no base of a Memory Stick; {}; or name one with --base DIR",
      base.string(),
      known.empty() ? fmt::format("the SDK has none at all in {}", models.string())
                    : fmt::format("the SDK has for {}: {}", model, fmt::join(known, ", "))));
}

void RobotSdk::GenerateStub(const fs::path& config, const fs::path& folder) const {
  // Runs the tool in `folder`, because stubgen2 writes to the folder in which it runs.
  Run({Tool("OPEN_R/bin/stubgen2"), config}, folder, config.filename().string());
}

void RobotSdk::Compile(const fs::path& source, const fs::path& object,
                       const std::vector<std::string>& options) const {
  const bool is_cxx = source.extension() != ".c";
  const fs::path include = root_ / "OPEN_R/include";
  std::vector<std::string> command = {
      Tool(is_cxx ? "bin/mipsel-linux-g++" : "bin/mipsel-linux-gcc"), "-O2", "-g", "-Wall"};
  command.insert(command.end(), options.begin(), options.end());
  for (const fs::path& folder : {include / "R4000", include / "MCOOP", include})
    command.push_back("-I" + folder.string());
  command.insert(command.end(), {"-c", "-o", object, source});
  Run(command, object.parent_path(), source);
}

void RobotSdk::Link(const fs::path& ocf, const std::vector<fs::path>& objects,
                    const std::vector<std::string>& libraries, const fs::path& image) const {
  std::vector<std::string> command = {Tool("OPEN_R/bin/mkbin"), "-p", root_, "-o", image, ocf};
  command.insert(command.end(), objects.begin(), objects.end());
  command.push_back("-L" + (root_ / "OPEN_R/lib").string());
  command.insert(command.end(), libraries.begin(), libraries.end());
  Run(command, image.parent_path(), image.filename());
  const std::string problem = RobotImageProblem(image);
  if (!problem.empty()) {
    throw std::runtime_error(
        fmt::format("{}, made by {}, {}", image.filename().string(), command[0], problem));
  }
}

std::string RobotSdk::SymbolLister() const {
  const std::string own = Tool("bin/mipsel-linux-nm");
  return access(own.c_str(), X_OK) == 0 ? own : "nm";
}

void RobotSdk::Run(const std::vector<std::string>& arguments, const fs::path& folder,
                   const std::string& what) const {
  if (is_verbose_) PrintPlain(stderr, "{}\n", fmt::join(arguments, " "));
  ProcessOptions options;
  options.folder = folder;
  options.has_no_input = true;
  // Puts the folders of the SDK first in PATH, because mkbin and the tools that it starts look in
  // PATH for each other and for the compiler.
  const char* const path = std::getenv("PATH");
  options.environment = {
      {"OPENRSDK_ROOT", root_},
      {"PATH", fmt::format("{}:{}:{}", (root_ / "bin").string(), (root_ / "OPEN_R/bin").string(),
                           path == nullptr ? "/usr/bin:/bin" : path)}};
  const ProcessResult result = RunProcess(arguments, options);
  if (result.good()) return;
  if (!result.start_error.empty()) {
    throw std::runtime_error(fmt::format("{}: {}", arguments[0], result.start_error));
  }
  throw std::runtime_error(
      fmt::format("{}: {} ended with status {}", what, arguments[0], result.status));
}

std::string RobotSdk::Tool(const char* name) const { return root_ / name; }

std::string RobotImageProblem(const fs::path& image) {
  const std::string bytes = ReadText(image).value_or("");
  if (bytes.empty()) return "is not there or empty";
  Elf32_Ehdr header;
  if (bytes.size() < sizeof header || std::memcmp(bytes.data(), ELFMAG, SELFMAG) != 0) {
    return "is no ELF file";
  }
  std::memcpy(&header, bytes.data(), sizeof header);
  const bool fits = header.e_ident[EI_CLASS] == ELFCLASS32 &&
                    header.e_ident[EI_DATA] == ELFDATA2LSB && header.e_machine == EM_MIPS;
  return fits ? "" : "is for another processor than the robot's 32-bit little-endian MIPS";
}

}  // namespace openr_host
