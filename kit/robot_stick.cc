#include "kit/robot_stick.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "cli/copy_file.h"
#include "cli/counted.h"
#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "kit/controller_main.h"
#include "kit/controller_sources.h"
#include "kit/robot_sdk.h"
#include "kit/sdk_tools.h"
#include "kit/shell_words.h"
#include "kit/stick_draft.h"
#include "kit/stick_merge.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Name of the folder beside OPEN-R/ for the ELF files of the images.
constexpr char kElfFolder[] = "elf";

struct RobotObject {
  const char* name;   // name of the object's class, folder and files
  const char* image;  // file name of the image
  bool has_common;    // true: the object is linked with the sources in objects/common
  bool has_network;
};

constexpr RobotObject kObjects[] = {{"PowerMonitor", "POWERMON.BIN", false, false},
                                    {"JointMover", "JOINTMOV.BIN", true, false},
                                    {"RCServer", "RCSERVER.BIN", true, true},
                                    {"Controller", "CONTROLL.BIN", true, false}};

std::vector<fs::path> SourcesIn(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && IsSourceName(entry.path())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

void ThrowIf(const std::vector<Diagnostic>& diagnostics, const char* what) {
  std::fputs(Render(diagnostics).c_str(), stderr);
  if (HasErrors(diagnostics)) throw std::runtime_error(what);
}

class RobotStick {
 public:
  explicit RobotStick(const RobotStickOptions& options)
      : options_(options),
        sources_(options.sources),
        sdk_(RobotSdk::FromEnvironment()),
        draft_(options.output) {
    sdk_.set_verbose(options.is_verbose);
    base_ = options.base.empty() ? sdk_.BaseStick(options.model == "ers7" ? "MS_ERS7" : "MS_ERS200",
                                                  options.flavour, options.is_protected)
                                 : fs::path(options.base);
    if (FindEntry(base_, "OPEN-R").empty()) {
      throw std::runtime_error(fmt::format("--base {}: there is no OPEN-R/ in it", base_.string()));
    }
  }

  void Make() {
    CopyTree(FindEntry(base_, "OPEN-R"), draft_.stick() / "OPEN-R");
    open_r_ = draft_.stick() / "OPEN-R";
    for (const char* name : {"OBJECT.CFG", "CONNECT.CFG", "DESIGNDB.CFG"}) MergeConfigFile(name);
    PutNetworkSettings();
    PutMotions();
    ThrowIf(CheckNames(draft_.stick()), "the robot's stick cannot hold these names");
    CompileController();  // compiled first, because most errors are in the controller
    CompileCommon();
    for (const RobotObject& object : kObjects) MakeImage(object);
    ThrowIf(CheckObjectConfig(draft_.stick()), "the stick is not complete");
    draft_.Finish();
    Tell();
  }

 private:
  // Returns the path of the file `name` in `folder`, a folder inside OPEN-R/ of the stick, and
  // creates the folder.  If the folder or the file already exists, its name keeps its upper and
  // lower case.
  fs::path On(const std::string& folder, const std::string& name) const {
    fs::path place = FindBelow(open_r_, folder);
    if (place.empty()) {
      place = open_r_ / folder;
      fs::create_directories(place);
    }
    const fs::path there = FindEntry(place, name);
    return there.empty() ? place / name : there;
  }

  void MergeConfigFile(const std::string& name) {
    const fs::path to = On("MW/CONF", name);
    const std::string ours = ReadText(sources_ / "stub.cfg" / name).value_or("");
    Write(to, MergeConfig(ReadText(to).value_or(""), ours));
  }

  // Writes the network settings, the file WLANCONF.TXT, to the stick.  Uses the WLANCONF.TXT in the
  // folder of the controller.  If this folder has none, uses the WLANCONF.TXT that the base (the
  // system files with which the stick begins) has put on the stick.  If the base has none either,
  // uses the WLANCONF.TXT in the folder stub.cfg/ of this project.
  void PutNetworkSettings() {
    const fs::path to = On("SYSTEM/CONF", "WLANCONF.TXT");
    fs::path from =
        options_.controller.empty() ? fs::path() : FindEntry(options_.controller, "WLANCONF.TXT");
    if (from.empty()) from = fs::exists(to) ? to : sources_ / "stub.cfg/WLANCONF.TXT";
    const std::string text = ReadText(from).value_or("");
    ThrowIf(CheckWlanConfig(from, text), "the network settings would not work on the robot");
    Write(to, text);
  }

  void PutMotions() {
    std::vector<fs::path> folders = {fs::path(options_.stick) / "OPEN-R/MW/DATA/P"};
    if (!options_.controller.empty()) folders.push_back(options_.controller);
    for (const fs::path& folder : folders) {
      for (const auto& entry : fs::directory_iterator(folder)) {
        if (LowerCase(entry.path().extension()) != ".mtn") continue;
        std::string name = entry.path().filename();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return std::toupper(c); });
        CopyFile(entry.path(), On("MW/DATA/P", name), fs::copy_options::overwrite_existing);
      }
    }
  }

  void CompileCommon() {
    for (const fs::path& source : SourcesIn(sources_ / "common"))
      common_.push_back(Compile(source, draft_.work() / "common", Includes({})));
  }

  void MakeImage(const RobotObject& object) {
    const fs::path folder = sources_ / object.name, work = draft_.work() / object.name;
    fs::create_directories(work);
    sdk_.GenerateStub(fs::canonical(sources_ / "stub.cfg" / (std::string(object.name) + ".cfg")),
                      work);
    const std::vector<std::string> includes = Includes({work, folder});
    std::vector<fs::path> objects;
    for (const fs::path& source : SourcesIn(folder))
      objects.push_back(Compile(source, work, includes));
    for (const fs::path& source : SourcesIn(work))  // sources of the stub
      objects.push_back(Compile(source, work, includes));
    if (object.name == std::string("Controller"))
      objects.insert(objects.end(), controller_.begin(), controller_.end());
    if (object.has_common) objects.insert(objects.end(), common_.begin(), common_.end());
    std::vector<std::string> libraries = {"-lObjectComm", "-lOPENR"};
    if (object.has_network) libraries.insert(libraries.end(), {"-lInternet", "-lantMCOOP"});
    const fs::path made = work / object.image;
    sdk_.Link(folder / (std::string(object.name) + ".ocf"), objects, libraries, made);
    if (RunGzcp({made, On("MW/OBJS", object.image)}) != 0) {
      throw std::runtime_error(fmt::format("{}: cannot be compressed", object.image));
    }
    KeepElfFile(made);
  }

  // Copies the ELF file that mkbin leaves beside an image to the folder kElfFolder.  openr emon
  // reads the line numbers in this file.  The folder is outside of OPEN-R/, because the file does
  // not belong on the robot's stick.
  void KeepElfFile(const fs::path& image) {
    const fs::path elf = fs::path(image).replace_extension(".nosnap.elf");
    std::error_code error;
    if (!fs::exists(elf, error)) return;
    fs::create_directories(draft_.stick() / kElfFolder);
    CopyFile(elf, draft_.stick() / kElfFolder / elf.filename());
  }

  // Compiles the controller.  Its main() gets the name controller_main(), because the generated
  // function CallControllerMain() calls it by that name.
  void CompileController() {
    ControllerSources sources;
    if (options_.controller.empty()) {
      sources.files = SourcesIn(sources_ / "Controller/ers210");
    } else {
      sources = FindControllerSources(fs::canonical(options_.controller));
    }
    ThrowIf(sources.diagnostics, "the controller is not complete");
    if (sources.files.empty() && sources.list.empty()) {
      throw std::runtime_error(fmt::format(
          "{}: no *.c, *.cc or *.cpp and no Makefile.sources in it", options_.controller));
    }
    for (const fs::path& source : sources.files) {
      std::vector<std::string> options = Includes({source.parent_path()});
      options.push_back("-Dmain=controller_main");
      controller_.push_back(Compile(source, draft_.work() / "controller", options));
    }
    CompileCallOfMain();
  }

  void CompileCallOfMain() {
    const ControllerMain main = FindControllerMain(sdk_.SymbolLister(), controller_);
    if (!main.problem.empty()) {
      throw std::runtime_error(fmt::format(
          "{}: {}", options_.controller.empty() ? "the default controller" : options_.controller,
          main.problem));
    }
    const fs::path work = draft_.work() / "controller", source = work / "ControllerMain.cc";
    fs::create_directories(work);
    Write(source, main.source);
    controller_.push_back(Compile(source, work, {}));
  }

  // Compiles one source and returns the object file.  Names of object files contain a number,
  // because two sources of an object may have the same name.
  fs::path Compile(const fs::path& source, const fs::path& work,
                   const std::vector<std::string>& options) {
    fs::create_directories(work);
    const fs::path object = work / fmt::format("{}-{}.o", source.stem().string(), num_compiled_);
    num_compiled_ += 1;
    sdk_.Compile(source, object, options);
    return object;
  }

  std::vector<std::string> Includes(const std::vector<fs::path>& folders) const {
    std::vector<std::string> options;
    for (const fs::path& folder : folders) options.push_back("-I" + folder.string());
    for (const char* folder : {"common", "Controller/include", "Controller/include/device"})
      options.push_back("-I" + (sources_ / folder).string());
    return options;
  }

  static void Write(const fs::path& file, const std::string& text) {
    const std::string problem = WriteText(file, text);
    if (!problem.empty()) throw std::runtime_error(problem);
  }

  void Tell() const {
    if (options_.base.empty() && options_.flavour == "BASIC") {
      PrintPlain(stderr, "warning: BASIC has no network, so RCServer has nobody to talk to\n");
    }
    const fs::path output = options_.output;
    for (const RobotObject& object : kObjects) {
      const uint64_t size =
          fs::file_size(FindBelow(output, std::string("OPEN-R/MW/OBJS/") + object.image));
      PrintPlain("{}  {}\n", object.image, Counted(size, "byte"));
    }
    PrintPlain("base: {}\n", base_.string());
    PrintPlain("copy {}/OPEN-R to a Programming Memory Stick\n", output.string());
    if (std::error_code error; fs::exists(output / kElfFolder, error)) {
      PrintPlain("keep {0} for crashes: openr emon EMON.LOG --image {0}/NAME.nosnap.elf\n",
                 (output / kElfFolder).string());
    }
  }

  const RobotStickOptions options_;
  const fs::path sources_;
  RobotSdk sdk_;
  StickDraft draft_;
  fs::path base_, open_r_;
  std::vector<fs::path> common_, controller_;  // object files
  int num_compiled_ = 0;
};

}  // namespace

void MakeRobotStick(const RobotStickOptions& options) {
  std::error_code error;
  if (!options.controller.empty() && !fs::is_directory(options.controller, error)) {
    throw std::runtime_error(
        fmt::format("--controller {}: is no folder; name the one that holds "
                    "the controller",
                    options.controller));
  }
  RobotStick(options).Make();
}

void MakeHostStick(const std::string& stick, const std::string& output) {
  StickDraft draft(output);
  CopyTree(FindEntry(stick, "OPEN-R"), draft.stick() / "OPEN-R");
  std::vector<fs::path> debug_files;
  for (const auto& entry : fs::recursive_directory_iterator(draft.stick()))
    if (entry.path().extension() == ".DBG") debug_files.push_back(entry);
  for (const fs::path& file : debug_files) fs::remove(file);
  // Creates the folder in which programs write files, because OPEN-R does not create missing
  // folders.
  fs::create_directories(WithCaseOnDisk(draft.stick(), "OPEN-R/MW/DATA/P"));
  draft.Finish();
  PrintPlain("{} run --stick {}\n", ShellWord(ProgramCall()), ShellWord(output));
}

}  // namespace openr_host
