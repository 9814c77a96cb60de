// What the tools of the SDK tree tell the `openr build` that runs the Makefile that runs them.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

struct KitLog {
  struct Image {
    std::string file;    // where mkbin wrote it
    std::string object;  // its name in the .ocf file
    std::string ocf;     // that file
  };
  struct Failure {
    std::string file;  // source or image that could not be made
    std::string why;   // "does not compile", or what is undefined
  };
  struct Repair {
    std::string place;  // "file:line"
    std::string what;
  };
  std::vector<Image> images;  // each file once, its last entry
  std::vector<Failure> failures;
  std::vector<Repair> repairs;
};

// Appends to the file named by $OPENR_KIT_LOG, if any.  Names are made absolute.  Safe when
// several tools run at once.
void LogImage(const KitLog::Image& image);
void LogFailure(const KitLog::Failure& failure);
void LogRepair(const KitLog::Repair& repair);

// An empty log when there is no such file.
KitLog ReadKitLog(const std::string& file);

void AppendKitLog(const std::string& file, const KitLog& log);

// Keeps only the images that are still there: what a build begins with.
void CleanKitLog(const std::string& file);

}  // namespace openr_host
