#include "kit/new_object.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>

#include "cli/process.h"
#include "kit/image_match.h"
#include "kit/new_object_text.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"
#include "runtime/base/spelling.h"
#include "runtime/config/ocf.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Names of the robot's own objects, which have no image on the stick.  No new object may have such
// a name, because two objects of one name cannot run.
constexpr const char* kRobotObjects[] = {"oobjectManager", "OVirtualRobotComm",
                                         "OVirtualRobotAudioComm", "IPStack", "tcpGateway"};

std::string Replaced(std::string text, const std::string& mark, const std::string& value) {
  for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
    text.replace(at, mark.size(), value);
  return text;
}

std::string ClassName(std::string name) {
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

// Returns whether a class called `class_name`, with calls of its functions as in a stub, compiles
// with the headers of the SDK tree `sdk_root`.
bool Compiles(const std::string& class_name, const std::string& sdk_root) {
  std::vector<std::string> command = HostCompiler(Language::kCxx);
  const std::vector<std::string> flags = ParseCompileFlags(
      ReadText(sdk_root + "/compile-flags.txt").value_or(""), Language::kCxx, IsClang(command));
  command.insert(command.end(), flags.begin(), flags.end());
  const std::vector<std::string> rest = {"-w", "-fsyntax-only", "-I", sdk_root + "/OPEN_R/include",
                                         "-x", "c++",           "-"};
  command.insert(command.end(), rest.begin(), rest.end());
  return RunProcess(command, {.captures_error = true,
                              .captures_out = true,
                              .input = Replaced(new_object::kNameCheck, "@Name@", class_name)})
      .good();
}

}  // namespace

std::string ObjectNameProblem(const std::string& name) {
  const bool begins_well = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
  bool is_word = begins_well;
  for (const char c : name) is_word = is_word && (std::isalnum(static_cast<unsigned char>(c)) != 0);
  if (!is_word) {
    return fmt::format(
        "'{}' cannot be the name of an object, which is a C++ class: letters and "
        "digits, a letter first, such as HelloWorld",
        name);
  }
  for (const char* const system_name : kRobotObjects) {
    if (!EqualsIgnoringCase(name, system_name)) continue;
    return fmt::format(
        "{} is an object of the robot itself, and two objects of one name cannot run; choose "
        "another name",
        system_name);
  }
  if (name.size() <= static_cast<size_t>(kObjectNameBytesMax)) return "";
  return fmt::format("the name has {} characters, {} are allowed", name.size(),
                     kObjectNameBytesMax);
}

std::string ClassNameProblem(const std::string& name, const std::string& sdk_root) {
  // If the class does not compile, compiles a class called HelloWorld.  If HelloWorld does not
  // compile either, the name `name` is not the reason.
  if (Compiles(ClassName(name), sdk_root) || !Compiles("HelloWorld", sdk_root)) return "";
  return fmt::format(
      "no class can be called {}, because the OPEN-R headers or those of C use this name; choose "
      "another name",
      ClassName(name));
}

std::vector<NewFile> MakeNewObject(const std::string& name) {
  const std::string class_name = ClassName(name);
  std::string object_name = name;
  object_name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  std::string image = ShortImageName(name);
  image.erase(image.find('.'));
  const auto filled = [&](const char* text) {
    return Replaced(Replaced(Replaced(text, "@Name@", class_name), "@name@", object_name), "@NAME@",
                    image);
  };
  using namespace new_object;
  const std::string folder = class_name + "/";
  const std::string config = "MS/OPEN-R/MW/CONF/";
  return {{folder + "stub.cfg", filled(kStub)},
          {folder + object_name + ".ocf", filled(kOcf)},
          {folder + class_name + ".h", filled(kHeader)},
          {folder + class_name + ".cc", filled(kSource)},
          {config + "OBJECT.CFG", filled(kObjectConfig)},
          {config + "CONNECT.CFG", filled(kConnectConfig)},
          {"Makefile", filled(kMakefile)},
          {"CMakeLists.txt", filled(kCMake)},
          {kIgnoreFile, filled(kIgnore)},
          {"test/" + class_name + "Test.cc", filled(kTest)}};
}

std::string WriteNewObject(const std::vector<NewFile>& files, const std::string& folder) {
  std::error_code error;
  for (const NewFile& file : files) {
    const fs::path path = fs::path(folder) / file.path;
    if (fs::exists(path, error)) return path.string() + " is there already; nothing was written";
  }
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string problem = WriteText(fs::path(folder) / files[i].path, files[i].text);
    if (problem.empty()) continue;
    // Removes the files that this call has written, because a second call would refuse to overwrite
    // them.  The user may try again, for example, after making room on a full disk.
    for (size_t j = 0; j < i; ++j) fs::remove(fs::path(folder) / files[j].path, error);
    return problem;
  }
  return "";
}

}  // namespace openr_host
