// A log file by which the compiler, the linker and other tools report to `openr build`.  The log is
// needed because `openr build` starts only make, and make starts the tools, so `openr build` gets
// no results from the tools directly.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace openr_host {

struct KitLog {
  struct Image {
    std::string file;                // path to which mkbin wrote the image
    std::string object;              // name of the object in the .ocf file
    std::string ocf;                 // path of the .ocf file
    std::vector<std::string> parts;  // the object files and libraries that were linked
  };
  struct Failure {
    std::string file;    // source that does not compile, or image that was not made
    std::string why;     // reason: "does not compile", or the undefined names
    std::string output;  // file that the tool was to make; "" if unknown
  };
  // A compilation of one source, successful or not.
  struct Compile {
    std::string file;
    std::string folder;  // working folder of the compiler
    // Flags of the Makefile such as -D and -I, with absolute folders.
    std::vector<std::string> flags;
  };
  // The command of the host's compiler for one source, for compile_commands.json.
  struct Command {
    std::string file;
    std::string folder;              // working folder of the compiler
    std::vector<std::string> words;  // compiler and flags, without source and output
  };
  struct Repair {
    std::string place;  // place of the repair: "file:line"
    std::string what;
  };
  std::vector<Image> images;  // the newest record of each image file
  // Failures to make a file, except those after which a later command has made the file.
  std::vector<Failure> failures;
  std::vector<Compile> compiles;  // the newest compilation of each source in each folder
  std::vector<Command> commands;  // the newest command for each source in each folder
  std::vector<Repair> repairs;
};

// LogImage() and the other Log functions append an entry to the log file that the environment
// variable OPENR_KIT_LOG names; without the variable they do nothing.  All of them but LogRepair()
// make the file names in the entry absolute.  Several processes may append at the same time.
void LogImage(const KitLog::Image& image);
void LogFailure(const KitLog::Failure& failure);
void LogCompile(const KitLog::Compile& compile);
void LogCommand(const KitLog::Command& command);

// Records in the log that the file `output` was made, so that earlier failures to make it no longer
// count.
void LogSuccess(const std::string& output);
void LogRepair(const KitLog::Repair& repair);

// Returns the content of the log file of a build; an empty log when there is no such file.
KitLog ReadKitLog(const std::string& file);

// Counts the sources that a build has compiled so far, from all logs of the build.
class CompileCounter {
 public:
  // Reads the log `file` and returns the number of sources compiled so far, in all logs that this
  // counter has read.  Compilations that a log already has at its first reading do not count,
  // because they belong to earlier builds.
  uint64_t CountIn(const std::string& file);

 private:
  struct Lines {
    uint64_t before = 0;  // compilations that the log had at the first reading
    uint64_t now = 0;     // largest number of compilations at a later reading, minus `before`
  };
  std::map<std::string, Lines> logs_;
};

void AppendKitLog(const std::string& file, const KitLog& log);

// Replaces the content of the log file `file` by `log`.
void WriteKitLog(const std::string& file, const KitLog& log);

// Removes all failures, all repairs, and each image whose file no longer exists, from the log
// `file`, which earlier builds have left.  Called at the beginning of a build, so that only the
// failures and repairs of the new build count.
void CleanKitLog(const std::string& file);

}  // namespace openr_host
