#include "kit/controller_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "cli/copy_file.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/controller_objects.h"
#include "kit/controller_sources.h"
#include "kit/project.h"
#include "kit/sdk_paths.h"
#include "kit/sdk_tools.h"
#include "kit/shell_words.h"
#include "kit/stick_merge.h"
#include "kit/text_files.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kImage[] = "CONTROLL.BIN";

class ControllerBuild {
 public:
  explicit ControllerBuild(const ControllerBuildOptions& options)
      : folder_(fs::canonical(options.folder)),
        stick_(options.output.empty() ? folder_ : fs::absolute(options.output)),
        template_(options.template_stick),
        part_(fs::path(SdkRoot()) / "controller") {}

  int Run() {
    const ControllerSources sources = FindControllerSources(folder_);
    std::fputs(Render(sources.diagnostics).c_str(), stderr);
    if (HasErrors(sources.diagnostics)) return kExitWrong;
    if (sources.files.empty() && sources.list.empty()) {
      throw std::runtime_error(
          fmt::format("{}: no *.c, *.cc or *.cpp and no Makefile.sources in it; 'openr controller "
                      "new' makes a controller to begin with",
                      folder_.string()));
    }
    const auto objects = CompileController(sources.files, folder_, scratch_.path());
    if (!objects || !HasGoodFiles() || !Link(*objects)) return kExitWrong;
    Deliver();
    PrintPlain("{}  {}\n", kImage,
               sources.files.empty() ? "empty: Makefile.sources names no source"
                                     : folder_.filename().string());
    PrintPlain("{} run --stick {}\n", ShellWord(ProgramCall()),
               ShellWord(stick_.lexically_normal()));
    return kExitGood;
  }

 private:
  bool Link(const Arguments& objects) {
    Arguments arguments = {"-o", ImagePath(), (part_ / "Controller.ocf").string(),
                           (part_ / "controller.o").string()};
    arguments.insert(arguments.end(), objects.begin(), objects.end());
    return RunMkbin(arguments) == 0;
  }

  // Returns whether the files of the controller's folder that are copied to the stick have no
  // errors, and prints their errors and warnings.  Errors are a motion file with a name that the
  // file system of a stick does not allow, and a WLANCONF.TXT with which the robot cannot boot.
  bool HasGoodFiles() const {
    std::vector<Diagnostic> diagnostics;
    std::vector<fs::directory_entry> entries{fs::directory_iterator(folder_), {}};
    // Sorts the files, because each file system lists the files of a folder in another order.
    std::sort(entries.begin(), entries.end());
    for (const auto& entry : entries) {
      const std::string name = entry.path().filename();
      if (LowerCase(name) == "wlanconf.txt") {
        const std::vector<Diagnostic> more =
            CheckWlanConfig(entry.path(), ReadText(entry.path()).value_or(""));
        diagnostics.insert(diagnostics.end(), more.begin(), more.end());
      }
      const std::string problem = IsMotion(entry.path()) ? ShortNameProblem(name) : "";
      if (!problem.empty())
        diagnostics.push_back({Severity::kError, entry.path(), 0, 0, problem, ""});
    }
    std::fputs(Render(diagnostics).c_str(), stderr);
    return !HasErrors(diagnostics);
  }

  static std::string NameOnStick(const fs::path& file) {
    std::string name = file.filename();
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return std::toupper(c); });
    return name;
  }
  static bool IsMotion(const fs::path& file) { return LowerCase(file.extension()) == ".mtn"; }

  void Deliver() {
    if (FindBelow(stick_, "OPEN-R/MW").empty()) {
      fs::create_directories(stick_);
      CopyFolder(fs::path(template_) / "OPEN-R", stick_ / "OPEN-R",
                 fs::copy_options::skip_existing);
    }
    StickFolder stick;
    stick.root = stick_;
    const fs::path images = stick.ObjectsFolder();
    fs::remove(images / "CONTROLL.DBG");  // old debug information, which does not fit the new image
    Put(ImagePath(), images / kImage);
    const fs::path open_r = FindEntry(stick_, "OPEN-R");
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = LowerCase(entry.path().filename());
      if (name == "wlanconf.txt") Put(entry.path(), open_r / "SYSTEM/CONF/WLANCONF.TXT");
      if (IsMotion(entry.path()))
        Put(entry.path(), open_r / "MW/DATA/P" / NameOnStick(entry.path()));
    }
  }

  static void Put(const fs::path& from, const fs::path& to) {
    fs::create_directories(to.parent_path());
    const std::string problem = CopyToFile(from, to);
    if (!problem.empty()) throw std::runtime_error(problem);
  }

  std::string ImagePath() const { return scratch_.path() + "/" + kImage; }

  const fs::path folder_;
  const fs::path stick_;
  const std::string template_;
  const fs::path part_;
  const TempFolder scratch_;
};

}  // namespace

int BuildController(const ControllerBuildOptions& options) {
  std::error_code error;
  if (!fs::is_directory(options.folder, error)) {
    throw std::runtime_error(
        fmt::format("{}: is no folder; name the one that holds the controller", options.folder));
  }
  if (const std::string problem = PathReadProblem(options.folder); !problem.empty())
    throw std::runtime_error(options.folder + ": " + problem);
  return ControllerBuild(options).Run();
}

}  // namespace openr_host
