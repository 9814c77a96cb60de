#include "cli/install_paths.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// The folder in lib/ that holds the libraries of an installation; in the build tree they lie in
// lib/ itself.
constexpr char kInstalledLibraries[] = "openr-host";

// Returns the folder that holds bin/openr, both in the build tree and after installing.
fs::path Prefix() { return fs::path(ProgramFolder()).parent_path(); }

// Returns the folder above the folder lib/ from which the runtime library was loaded.  A test
// program may be in any folder, so it finds the files of the installation by the place of this
// library.
fs::path RuntimePrefix() {
  Dl_info info{};
  if (dladdr(dlsym(RTLD_DEFAULT, "openr_second_stack_new"), &info) == 0) return Prefix();
  const fs::path folder = fs::path(info.dli_fname).parent_path();
  const bool is_installed = folder.filename() == kInstalledLibraries;
  return (is_installed ? folder.parent_path() : folder).parent_path();
}

// The folder with the program's data, relative to the folder of an installation (Prefix()) or to
// the build tree.
constexpr char kDataFolder[] = "share/openr-host";

std::vector<fs::path> DataFolders() {
  return {Prefix(), Prefix() / kDataFolder, RuntimePrefix(), RuntimePrefix() / kDataFolder};
}

// Returns the paths of the .json files in `folders`, sorted by file name.  If several folders have
// a file of the same name, returns only the path in the first of these folders.
std::vector<fs::path> JsonFiles(const std::vector<fs::path>& folders) {
  // For each file name: the path of the file in the first of `folders` that has such a file.
  std::map<fs::path, fs::path> files;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".json") files.emplace(entry.path().filename(), entry.path());
    }
  }
  std::vector<fs::path> paths;
  for (const auto& [name, path] : files) paths.push_back(path);
  return paths;
}

std::string LibraryBesideProgram(const char* name) {
  for (const fs::path& folder : {Prefix() / "lib", Prefix() / "lib" / kInstalledLibraries}) {
    std::error_code error;
    if (fs::is_regular_file(folder / name, error)) return folder / name;
  }
  return name;
}

}  // namespace

std::string ProgramFile() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  if (error) throw std::runtime_error("/proc/self/exe: " + error.message());
  return self;
}

std::string ProgramFolder() { return fs::path(ProgramFile()).parent_path(); }

std::string ProgramCall() {
  const fs::path self = ProgramFile();
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path found = fs::path(folder.empty() ? "." : folder) / self.filename();
    std::error_code error;
    if (!fs::is_regular_file(found, error)) continue;
    const bool is_self = fs::equivalent(found, self, error);
    if (is_self && !error) return self.filename();
    break;  // a shell would start this other program, so the path is returned below
  }
  const fs::path relative = self.lexically_relative(fs::current_path());
  const bool is_below = !relative.empty() && *relative.begin() != "..";
  if (!is_below) return self;
  return relative.has_parent_path() ? relative : "." / relative;
}

std::string DefaultStick() {
  std::string looked;
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    if (fs::is_directory(folder / "stick" / "OPEN-R", error)) return folder / "stick";
    looked += fmt::format(" {}", (folder / "stick").string());
  }
  throw std::runtime_error(fmt::format(
      "no default stick in{}; build the target 'stick', or name one with --stick DIR", looked));
}

std::string ObjectSources() {
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    if (fs::is_directory(folder / "objects" / "stub.cfg", error)) return folder / "objects";
  }
  throw std::runtime_error(fmt::format("no sources of objects in {}; install openr-host whole",
                                       (Prefix() / "share/openr-host/objects").string()));
}

std::string ModelFile(const std::string& name) {
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    const fs::path file = folder / "model" / (name + ".json");
    if (name.find('/') == std::string::npos && fs::is_regular_file(file, error)) return file;
  }
  throw std::runtime_error(
      fmt::format("no robot model '{}'; there are: {}", name, fmt::join(ModelNames(), ", ")));
}

std::vector<std::string> ModelNames() {
  std::vector<fs::path> folders;
  for (const fs::path& folder : DataFolders()) folders.push_back(folder / "model");
  std::vector<std::string> names;
  for (const fs::path& file : JsonFiles(folders)) names.push_back(file.stem());
  return names;
}

std::vector<std::string> WorldNames() {
  std::vector<std::string> names;
  for (const fs::path& file : JsonFiles({Prefix() / kDataFolder, RuntimePrefix() / kDataFolder}))
    names.push_back(file.filename());
  return names;
}

std::string DataFile(const std::string& name) {
  std::error_code error;
  if (fs::exists(name, error) || name.find('/') != std::string::npos) return name;
  for (const fs::path& folder : DataFolders()) {
    if (fs::is_regular_file(folder / name, error)) return folder / name;
  }
  return name;
}

std::string GdbPrinters() {
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    const fs::path file = folder / "gdb" / "openr_printers.py";
    if (fs::is_regular_file(file, error)) return file;
  }
  return "";
}

std::string PanelFolder() {
  for (const fs::path& folder : DataFolders()) {
    std::error_code error;
    if (fs::is_regular_file(folder / "panel" / "index.html", error)) return folder / "panel";
  }
  return "";
}

std::string PanelLibrary() { return LibraryBesideProgram("libopenr_panel.so"); }

std::string ControllerLibrary() { return LibraryBesideProgram("libopenr_controller.so"); }

std::string RenderLibrary() { return LibraryBesideProgram("libopenr_render.so"); }

std::string ChartLibrary() { return LibraryBesideProgram("libopenr_chart.so"); }

}  // namespace openr_host
