#include "openr/kit/controller_build.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "openr/exit_code.h"
#include "openr/kit/controller_sources.h"
#include "openr/kit/project.h"
#include "openr/kit/sdk_paths.h"
#include "openr/kit/sdk_tools.h"
#include "openr/kit/text_files.h"
#include "runtime/core/temp_folder.h"

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
    if (scratch_.path().empty()) throw std::runtime_error("no room for temporary files");
    if (!Compile(sources.files) || !Link()) return kExitWrong;
    Deliver();
    fmt::print("{}  {}\n", kImage,
               sources.files.empty() ? "empty: Makefile.sources names no source"
                                     : folder_.filename().string());
    fmt::print("openr run --stick {}\n", stick_.lexically_normal().string());
    return kExitGood;
  }

 private:
  // Each source where it lies, so that complaints and a debugger name it.
  bool Compile(const std::vector<fs::path>& sources) {
    bool good = true;
    for (const fs::path& source : sources) {
      const std::string object = fmt::format("{}/{}.o", scratch_.path(), objects_.size());
      const bool is_cxx = source.extension() != ".c";
      const fs::path include = part_ / "include";
      good = RunCompiler(
                 {"-O2", "-Dmain=controller_main", "-I" + folder_.string(), "-I" + include.string(),
                  "-I" + (include / "device").string(), "-c", "-o", object, source.string()},
                 is_cxx) == 0 &&
             good;
      objects_.push_back(object);
    }
    return good;
  }

  bool Link() {
    Arguments arguments = {"-o", Made(), (part_ / "Controller.ocf").string(),
                           (part_ / "controller.o").string()};
    arguments.insert(arguments.end(), objects_.begin(), objects_.end());
    return RunMkbin(arguments) == 0;
  }

  void Deliver() {
    if (FindBelow(stick_, "OPEN-R/MW").empty()) {
      fs::create_directories(stick_);
      fs::copy(fs::path(template_) / "OPEN-R", stick_ / "OPEN-R",
               fs::copy_options::recursive | fs::copy_options::skip_existing);
    }
    StickFolder stick;
    stick.root = stick_;
    const fs::path images = stick.ObjectsFolder();
    fs::remove(images / "CONTROLL.DBG");  // of another image
    Put(Made(), images / kImage);
    const fs::path open_r = FindEntry(stick_, "OPEN-R");
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = LowerCase(entry.path().filename());
      if (name == "wlanconf.txt") Put(entry.path(), open_r / "SYSTEM/CONF/WLANCONF.TXT");
      if (entry.path().extension() == ".MTN")
        Put(entry.path(), open_r / "MW/DATA/P" / entry.path().filename());
    }
  }

  static void Put(const fs::path& from, const fs::path& to) {
    fs::create_directories(to.parent_path());
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
  }

  std::string Made() const { return scratch_.path() + "/" + kImage; }

  const fs::path folder_;
  const fs::path stick_;
  const std::string template_;
  const fs::path part_;
  const TempFolder scratch_;
  Arguments objects_;
};

}  // namespace

int BuildController(const ControllerBuildOptions& options) {
  std::error_code error;
  if (!fs::is_directory(options.folder, error)) {
    throw std::runtime_error(
        fmt::format("{}: is no folder; name the one that holds the controller", options.folder));
  }
  return ControllerBuild(options).Run();
}

}  // namespace openr_host
