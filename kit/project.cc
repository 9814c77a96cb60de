#include "kit/project.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>

#include "kit/controller_sources.h"
#include "kit/makefile_text.h"
#include "kit/referred_places.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"
#include "runtime/config/line_file.h"
#include "runtime/config/stub_config.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool DefinesEntryTable(const std::string& text) {
  static const std::regex kTable("ObjectEntry\\s+ObjectEntryTable\\s*\\[");
  return text.find("ObjectEntryTable") != std::string::npos && std::regex_search(text, kTable);
}

// Returns whether the file has the name of a stub that stubgen2 makes, such as SenderStub.cc for
// the class Sender.
bool IsGenerated(const fs::path& file, const std::string& class_name) {
  return !class_name.empty() && file.stem() == class_name + "Stub";
}

ObjectFolder DescribeObject(const fs::path& folder, const std::vector<fs::path>& files) {
  ObjectFolder object;
  object.folder = folder;
  for (const fs::path& file : files) {
    if (LowerCase(file.filename()) == "stub.cfg") object.stub = file;
    if (LowerCase(file.extension()) == ".ocf") object.ocfs.push_back(file);
  }
  if (!object.stub.empty()) {
    object.class_name =
        ParseStubConfig("stub.cfg", ReadText(object.stub).value_or("")).config.object_name;
  }
  for (const fs::path& file : files) {
    if (IsSourceName(file) && !IsGenerated(file, object.class_name)) object.sources.push_back(file);
    if (!IsMainMakefileName(file)) continue;
    for (const std::string& name : InstalledImages(ReadText(file).value_or("")))
      object.image_names.push_back(name);
  }
  return object;
}

// Returns whether a folder with the files `files` is the folder of an object.  Such a folder has a
// stub.cfg, or an .ocf file and a source with a table of the object's handlers (entry table).
bool IsObjectFolder(const std::vector<fs::path>& files) {
  bool has_ocf = false, has_table = false;
  for (const fs::path& file : files) {
    if (LowerCase(file.filename()) == "stub.cfg") return true;
    has_ocf = has_ocf || LowerCase(file.extension()) == ".ocf";
    has_table = has_table || (IsSourceName(file) && DefinesEntryTable(ReadText(file).value_or("")));
  }
  return has_ocf && has_table;
}

StickFolder DescribeStick(const fs::path& root) {
  StickFolder stick;
  stick.root = root;
  stick.object_config = FindBelow(root, "OPEN-R/MW/CONF/OBJECT.CFG");
  if (stick.object_config.empty()) return stick;
  const std::string text = ReadText(stick.object_config).value_or("");
  stick.objects = ParseObjectConfig("OBJECT.CFG", text, kEveryDesign).objects;
  // Keeps only the first line of OBJECT.CFG that names an image, because several sections of this
  // file, for different robots, may name the same image.
  std::set<std::string> seen;
  std::erase_if(stick.objects, [&](const ObjectRecord& record) {
    return !seen.insert(LowerCase(record.path)).second;
  });
  return stick;
}

void FindSticks(const fs::path& folder, std::vector<StickFolder>* sticks) {
  if (!FindBelow(folder, "OPEN-R/MW").empty()) {
    sticks->push_back(DescribeStick(folder));
    return;
  }
  std::vector<fs::path> below;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_directory(error) && !entry.is_symlink(error) && !IsIgnoredFolder(entry.path()))
      below.push_back(entry.path());
  }
  std::sort(below.begin(), below.end());
  for (const fs::path& entry : below) FindSticks(entry, sticks);
}

bool IsInStick(const fs::path& path, const Project& project) {
  return std::any_of(project.sticks.begin(), project.sticks.end(), [&](const StickFolder& stick) {
    return path != stick.root && IsBelow(path, FindEntry(stick.root, "OPEN-R"));
  });
}

}  // namespace

fs::path StickFolder::ObjectsFolder() const {
  const fs::path middleware = FindBelow(root, "OPEN-R/MW");
  if (middleware.empty()) return root / "OPEN-R/MW/OBJS";
  const fs::path objects = FindEntry(middleware, "OBJS");
  return objects.empty() ? middleware / "OBJS" : objects;
}

Project ScanProject(const std::vector<fs::path>& folders) {
  Project project;
  project.root = folders[0];
  std::map<fs::path, std::vector<fs::path>> files_of;
  // The files found already, so that no file is added twice.  FilesBelow() finds a file twice if a
  // folder of `folders` is inside another folder of `folders`.
  std::set<fs::path> seen;
  for (const fs::path& folder : folders) {
    // Searches folders outside of the project for sticks only if the project has no stick of its
    // own, because a build must not write to the stick of another program.
    if (project.sticks.empty()) FindSticks(folder, &project.sticks);
    for (const fs::path& file : FilesBelow(folder))
      if (seen.insert(file).second) files_of[file.parent_path()].push_back(file);
  }
  std::set<fs::path> object_folders;
  for (const auto& [folder, files] : files_of) {
    if (IsInStick(folder, project) || !IsObjectFolder(files)) continue;
    project.objects.push_back(DescribeObject(folder, files));
    object_folders.insert(folder);
  }
  const auto is_ours = [&](const ObjectFolder& object) {
    return IsBelow(object.folder, project.root);
  };
  // If the project has objects of its own, moves the objects in folders outside of the project to
  // `neighbours`, so that these objects are not built.
  if (std::any_of(project.objects.begin(), project.objects.end(), is_ours)) {
    const auto first =
        std::stable_partition(project.objects.begin(), project.objects.end(), is_ours);
    project.neighbours.assign(first, project.objects.end());
    project.objects.erase(first, project.objects.end());
  }
  for (const auto& [folder, files] : files_of) {
    if (IsInStick(folder, project)) continue;
    bool has_header = false;
    for (const fs::path& file : files) {
      if (IsMakefileName(file)) project.makefiles.push_back(file);
      has_header = has_header || IsHeaderName(file);
      if (IsSourceName(file) && !object_folders.contains(folder))
        project.shared_sources.push_back(file);
    }
    if (has_header && !object_folders.contains(folder)) project.header_folders.push_back(folder);
  }
  return project;
}

void CheckProjectHasProgram(const Project& project, const fs::path& folder) {
  if (!project.objects.empty()) return;
  if (IsControllerFolder(folder)) {
    throw std::runtime_error(
        fmt::format("{}: a controller, not an OPEN-R object; openr controller build {}",
                    folder.string(), ShellWord(folder)));
  }
  if (project.makefiles.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: no stub.cfg, no entry table and no Makefile in it or below; 'openr new' makes an "
        "object to begin with",
        folder.string()));
  }
}

void CheckFolderHasProgram(const fs::path& folder) {
  if (const std::string problem = PathReadProblem(folder); !problem.empty())
    throw std::runtime_error(fmt::format("{}: {}", folder.string(), problem));
  const ReferredPlaces places = FindReferredPlaces(folder);
  // Makes no check here if the program has files in folders of `places.around`.  These files may be
  // all that can be built, and a scan of `places.folders` does not find them.  FolderBuild::Run()
  // checks again later, in the private copies, which have these files.
  if (places.files.empty()) CheckProjectHasProgram(ScanProject(places.folders), folder);
}

bool IsGeneratedDefinitions(const std::string& text) {
  return text.find("numOfSubject") != std::string::npos ||
         text.find("numOfObserver") != std::string::npos;
}

std::string FileNameOf(const ObjectRecord& record) {
  return record.path.substr(record.path.rfind('/') + 1);
}

}  // namespace openr_host
