// The outcome of openr build, and the messages by which openr build reports it to the user.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "kit/kit_log.h"
#include "kit/project.h"
#include "kit/work_copy.h"

namespace openr_host {

struct BuildOutcome {
  bool is_made = false;    // true: all runs of make have succeeded
  std::string make_cause;  // the reason why make failed; "": unknown
  bool wants_all = false;  // true: no stick has an OBJECT.CFG, so all images must be made
  std::vector<std::string> start_problems;  // reasons why the build of some objects could not begin
  std::vector<std::string> missing;         // images that OBJECT.CFG names and that were not made
  std::vector<std::string> problems;        // errors
  std::vector<std::string> notes;
  std::vector<std::string> sticks;  // folders of the finished sticks
};

// Describes the failures of a build to the user.  Knows the folders of the build, and so names the
// object of each failure.
class BuildReport {
 public:
  // `project` is what the build has found in `copy`, the private copy of the user's folder, which
  // is in the folder `work`.  Both must outlive the BuildReport.  `log` is the file of the KitLog.
  BuildReport(const Project& project, const WorkCopy& copy, std::filesystem::path work,
              std::string log);

  // Returns whether the build of some object has failed or could not begin.
  bool HasFailed(const BuildOutcome& outcome) const;

  // Adds the failures of the build to `outcome`: as errors if an image is missing, else as notes.
  void AddFailures(BuildOutcome* outcome) const;

 private:
  std::vector<std::string> NeededForeignFiles() const;
  std::string ObjectOf(const std::filesystem::path& file) const;
  std::string Described(const KitLog::Failure& failure) const;

  const Project& project_;
  const WorkCopy& copy_;
  const std::filesystem::path work_;
  const std::string log_;
};

// Prints the notes and errors of a build, and the commands that run the finished sticks.  Returns
// the exit code.
int PrintOutcome(const BuildOutcome& outcome);

}  // namespace openr_host
