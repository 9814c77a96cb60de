#include "openr/run/gdb_start.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>

#include "cli/install_paths.h"
#include "cli/process_arguments.h"
#include "kit/gdb_settings.h"
#include "runtime/base/spelling.h"
#include "runtime/config/ocf.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

std::string Demangled(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> text(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && text != nullptr ? text.get() : "";
}

// Returns the name of the object in the image `file`; "" if the file is no image for this machine.
std::string ObjectIn(const fs::path& file, const std::string& bytes) {
  const OcfResult ocf = ParseOcf(file, OcfTextOf(bytes));
  return ocf.ocf ? ocf.ocf->name : "";
}

// Returns the bytes of the image that contains the object `object`.  Looks for the image on the
// stick in the folder `stick`.  The case of letters in `object` counts only if two objects differ
// in nothing else.
std::string ImageOf(const std::string& object, const std::string& stick) {
  std::map<std::string, fs::path> images;  // the image of each object
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(stick))) {
    if (!entry.is_regular_file()) continue;
    const ImageFile image = ReadImageFile(entry.path());
    if (!image.problem.empty()) continue;
    const std::string name = ObjectIn(entry.path(), image.bytes);
    if (!name.empty()) images.emplace(name, entry.path());
  }
  std::vector<std::string> names;
  for (const auto& [name, image] : images) names.push_back(name);
  if (const auto match = MatchIgnoringCase(object, names))
    return ReadImageFile(images.at(*match)).bytes;
  throw std::runtime_error(fmt::format("--gdb: no object '{}' on {}{}; it has {}", object, stick,
                                       DidYouMean(object, names), fmt::join(names, ", ")));
}

// Returns the command line of this process without --gdb and its value.  Adds flags so that a run
// under a debugger has no time limit for handlers and leaves the terminal to gdb, unless the user
// has set these flags.
std::vector<std::string> WordsOfTheRun() {
  std::vector<std::string> words;
  const std::vector<std::string> given = ProcessArguments();
  for (size_t i = 0; i < given.size(); ++i) {
    if (given[i] == "--gdb") {
      ++i;
    } else if (!given[i].starts_with("--gdb=")) {
      words.push_back(given[i]);
    }
  }
  words[0] = ProgramFile();
  const auto has = [&words](const std::string& flag) {
    return std::any_of(words.begin(), words.end(), [&flag](const std::string& word) {
      return word == flag || word.starts_with(flag + "=");
    });
  };
  if (!has("--handler-limit")) words.insert(words.end(), {"--handler-limit", "0s"});
  if (!has("--stdin")) words.insert(words.end(), {"--stdin", "/dev/null"});
  return words;
}

}  // namespace

std::vector<std::string> HandlersAmong(const std::vector<std::string>& functions) {
  static const std::regex kMethod(
      "(\\w+)::\\w+\\((?:O(System|Notify|Ready|Control|Connect)Event const&|void\\*)\\)");
  std::vector<std::string> methods;
  // The names of the classes that have a function DoInit().  Such classes are the classes of
  // objects; the methods of all other classes are removed below, because they are no handlers.
  std::vector<std::string> classes;
  for (const std::string& function : functions) {
    const std::string name = Demangled(function);
    std::smatch match;
    if (!std::regex_match(name, match, kMethod)) continue;
    methods.push_back(name);
    if (name.find("::DoInit(") != std::string::npos) classes.push_back(match[1]);
  }
  std::erase_if(methods, [&classes](const std::string& method) {
    const std::string name = method.substr(0, method.find(':'));
    return std::find(classes.begin(), classes.end(), name) == classes.end();
  });
  std::sort(methods.begin(), methods.end());
  methods.erase(std::unique(methods.begin(), methods.end()), methods.end());
  return methods;
}

std::vector<std::string> GdbCommand(const std::vector<std::string>& handlers,
                                    const std::string& printers,
                                    const std::vector<std::string>& program) {
  std::vector<std::string> words{"gdb", "-q"};
  const auto tell = [&words](const std::string& command) {
    words.insert(words.end(), {"-ex", command});
  };
  for (const std::string& command : GdbSettings(printers)) tell(command);
  for (const std::string& handler : handlers) tell("break " + handler);
  tell("run");
  words.push_back("--args");
  words.insert(words.end(), program.begin(), program.end());
  return words;
}

void StartUnderGdb(const std::string& object, const std::string& stick) {
  const std::string folder = stick.empty() ? DefaultStick() : stick;
  std::vector<std::string> handlers = HandlersAmong(FunctionsIn(ImageOf(object, folder)));
  if (handlers.empty()) {
    throw std::runtime_error(
        fmt::format("--gdb: the image of {} has no symbols; build it without strip", object));
  }
  std::vector<std::string> words = GdbCommand(handlers, GdbPrinters(), WordsOfTheRun());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp("gdb", arguments.data());
  throw std::runtime_error(fmt::format("--gdb: gdb cannot be started: {}; install the package gdb",
                                       std::strerror(errno)));
}

}  // namespace openr_host
