// What the tools of the SDK tree tell the `openr build` that runs the Makefile that runs them.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct KitLog {
  struct Image {
    std::string file;                // where mkbin wrote it
    std::string object;              // its name in the .ocf file
    std::string ocf;                 // that file
    std::vector<std::string> parts;  // object files and libraries it was linked of
  };
  struct Failure {
    std::string file;    // source or image that could not be made
    std::string why;     // "does not compile", or what is undefined
    std::string output;  // what it would have become; "" if unknown
  };
  // A source that was compiled, well or not.
  struct Compile {
    std::string file;
    std::string folder;              // where the compiler ran
    std::vector<std::string> flags;  // of the Makefile: -D, -I and the like, folders absolute
  };
  struct Repair {
    std::string place;  // "file:line"
    std::string what;
  };
  std::vector<Image> images;      // each file once, its last entry
  std::vector<Failure> failures;  // each once, and none that was made good later
  std::vector<Compile> compiles;  // each file and folder once, the last entry
  std::vector<Repair> repairs;
};

// Appends to the file named by $OPENR_KIT_LOG, if any.  Names are made absolute.  Safe when
// several tools run at once.
void LogImage(const KitLog::Image& image);
void LogFailure(const KitLog::Failure& failure);
void LogCompile(const KitLog::Compile& compile);

// Says that `output` was made, whatever failed before.
void LogSuccess(const std::string& output);
void LogRepair(const KitLog::Repair& repair);

// An empty log when there is no such file.
KitLog ReadKitLog(const std::string& file);

void AppendKitLog(const std::string& file, const KitLog& log);

// Writes `log` in the place of what the file holds.
void WriteKitLog(const std::string& file, const KitLog& log);

// Removes failures, repairs, and images that no longer exist from the log.  Called when a build
// begins.
void CleanKitLog(const std::string& file);

}  // namespace openr_host
