#include "kit/build_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "cli/print_plain.h"
#include "kit/build_progress.h"
#include "kit/build_report.h"
#include "kit/compile_database.h"
#include "kit/complete_stick.h"
#include "kit/convention_build.h"
#include "kit/foreign_code.h"
#include "kit/kit_log.h"
#include "kit/make_build.h"
#include "kit/project.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"
#include "kit/work_copy.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Name of a file in the folder in which `openr build` keeps its results.  The file contains the
// text of KitIdentity() for the SDK tree and the compilers that made these results.
constexpr char kIdentityFile[] = "kit.txt";

// Name of a file in the folder in which `openr build` keeps its results.  The file contains the
// path of the user's folder that was built.
constexpr char kOwnerFile[] = "folder.txt";

// Returns a text that changes if the SDK tree, the host's compilers or the flags of `variant`
// change.  If the text has changed since the last build, the build begins anew, so that results of
// different versions are not mixed.
std::string KitIdentity(const std::string& sdk_root, BuildVariant variant) {
  fs::file_time_type newest = fs::file_time_type::min();
  for (const char* part : {"OPEN_R/include", "compat", "compile-flags.txt", "images"}) {
    const fs::path path = fs::path(sdk_root) / part;
    std::vector<fs::path> files{path};
    if (fs::is_directory(path)) files = FilesBelow(path);
    for (const fs::path& file : files) newest = std::max(newest, fs::last_write_time(file));
  }
  return fmt::format("{} {} {} {} {}\n", sdk_root, newest.time_since_epoch().count(),
                     fmt::join(HostCompiler(Language::kCxx), " "),
                     fmt::join(HostCompiler(Language::kC), " "),
                     fmt::join(VariantCompileFlags(variant), " "));
}

class FolderBuild {
 public:
  explicit FolderBuild(const BuildOptions& options)
      : options_(options),
        folder_(fs::canonical(options.folder)),
        work_(fs::weakly_canonical(options.work.empty()
                                       ? DefaultWorkFolder(folder_, options.variant)
                                       : fs::absolute(options.work))),
        sdk_root_(SdkRoot()) {}

  ~FolderBuild() {
    if (lock_ >= 0) close(lock_);
  }
  FolderBuild(const FolderBuild&) = delete;
  FolderBuild& operator=(const FolderBuild&) = delete;

  int Run();

 private:
  void PrepareWork();
  void CheckWorkFolder() const;
  void Build();
  void TryConvention(const std::vector<ObjectFolder>& objects, const MakePlan& plan);
  bool HasFailure(const ObjectFolder& object) const;
  std::vector<ObjectFolder> NotBuilt() const;
  std::vector<KitLog::Image> RemoveOldImages(bool is_made);
  bool SomeImageIsMissing() const;
  void Deliver();
  std::string OriginalName(const std::string& file) const;

  const BuildOptions options_;
  const fs::path folder_;  // the user's folder, which is built
  const fs::path work_;
  const std::string sdk_root_;
  int lock_ = -1;
  MakeOptions make_;
  std::optional<WorkCopy> copy_;
  std::vector<SourceCopy> copies_;
  std::vector<fs::path> copied_folders_;
  Project project_;
  std::optional<BuildReport> report_;
  BuildOutcome outcome_;
};

// Throws if `work_`, the folder for private copies, is used for another folder of the user or holds
// files that no build has made.
void FolderBuild::CheckWorkFolder() const {
  std::error_code error;
  if (!fs::exists(work_, error)) return;
  if (!fs::is_directory(work_, error) ||
      (!fs::is_empty(work_, error) && !fs::exists(work_ / kIdentityFile, error))) {
    throw std::runtime_error(fmt::format(
        "{}: holds files that are not of a build; name a new or empty folder with --work",
        work_.string()));
  }
  const auto owner = ReadText(work_ / kOwnerFile);
  if (!owner || *owner == folder_.string() || options_.is_fresh) return;
  throw std::runtime_error(fmt::format(
      "{}: holds what was built of {}; name another folder with --work, or begin anew with --fresh",
      work_.string(), *owner));
}

void FolderBuild::PrepareWork() {
  std::error_code error;
  fs::create_directories(work_.parent_path(), error);
  // Locks the folder for private copies, so that this build waits for the end of another build of
  // the same folder of the user.
  lock_ = open((work_.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ >= 0) flock(lock_, LOCK_EX);
  CheckWorkFolder();
  const std::string identity = KitIdentity(sdk_root_, options_.variant);
  const fs::path identity_file = work_ / kIdentityFile;
  if (options_.is_fresh || ReadText(identity_file) != identity) fs::remove_all(work_);
  fs::create_directories(work_, error);
  const std::string problem = WriteText(identity_file, identity);
  if (!problem.empty()) throw std::runtime_error(problem + "; name another folder with --work");
  WriteText(work_ / kOwnerFile, folder_.string());
  // Removes the images that the last build copied to the sticks, so that they do not count as
  // images of this build.  The file placed.txt lists these images.
  std::istringstream placed(ReadText(work_ / "placed.txt").value_or(""));
  for (std::string file; std::getline(placed, file);) fs::remove(file);
  make_.sdk_root = sdk_root_;
  make_.log = work_ / "log.txt";
  make_.variant = VariantName(options_.variant);
  make_.is_verbose = options_.is_verbose;
  make_.jobs = options_.jobs > 0
                   ? options_.jobs
                   : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  CleanKitLog(make_.log);
}

int FolderBuild::Run() {
  CheckFolderHasProgram(folder_);
  PrepareWork();
  copy_.emplace(work_, sdk_root_);
  copy_->Add(folder_);
  copies_ = copy_->copies();
  make_.copies = ToEnvironment(copies_);
  for (const SourceCopy& entry : copies_) copied_folders_.emplace_back(entry.copy);
  project_ = ScanProject(copied_folders_);
  report_.emplace(project_, *copy_, work_, make_.log);
  CheckProjectHasProgram(project_, folder_);
  Build();
  Deliver();
  if (options_.writes_database)
    WriteCompileDatabase(folder_, ReadKitLog(make_.log), copies_, &outcome_.problems);
  report_->AddFailures(&outcome_);
  return PrintOutcome(outcome_);
}

// Returns whether a file of `object` does not compile or link.
bool FolderBuild::HasFailure(const ObjectFolder& object) const {
  const std::vector<KitLog::Failure> failures = ReadKitLog(make_.log).failures;
  return std::any_of(failures.begin(), failures.end(), [&](const KitLog::Failure& failure) {
    return IsBelow(failure.file, object.folder) || IsBelow(failure.output, object.folder);
  });
}

// Returns the objects that have no image from this build.  Leaves out objects with a failed source,
// because the source would fail again if the object were built in another way.
std::vector<ObjectFolder> FolderBuild::NotBuilt() const {
  const KitLog log = ReadKitLog(make_.log);
  std::vector<ObjectFolder> objects;
  for (const ObjectFolder& object : project_.objects) {
    const bool is_built =
        std::any_of(log.images.begin(), log.images.end(), [&](const KitLog::Image& image) {
          return IsBelow(image.ocf, object.folder) || IsBelow(image.file, object.folder);
        });
    if (!is_built && !HasFailure(object)) objects.push_back(object);
  }
  return objects;
}

void FolderBuild::Build() {
  const MakePlan plan = PlanMake(project_, sdk_root_);
  if (plan.folders.empty()) {
    TryConvention(project_.objects, plan);
    return;
  }
  MakeOutcome outcome;
  ShowBuildProgress(
      &make_,
      [&] {
        const std::optional<uint64_t> planned = CountPlannedCompiles(plan, make_);
        return planned == 0 ? CountByConvention(project_, project_.objects) : planned;
      },
      [&] { outcome = RunMake(plan, make_); });
  const std::vector<KitLog::Image> removed = RemoveOldImages(outcome.is_good);
  // Runs make also in the folder of each object that has no image yet, because a Makefile in a
  // parent folder often runs make for one object after the other, and ends at the first object that
  // fails.
  if (!outcome.is_good) {
    for (const ObjectFolder& object : NotBuilt()) {
      const bool has_makefile =
          std::any_of(project_.makefiles.begin(), project_.makefiles.end(), [&](const fs::path& f) {
            return f.parent_path() == object.folder && IsMainMakefileName(f);
          });
      const bool is_top =
          std::find(plan.folders.begin(), plan.folders.end(), object.folder) != plan.folders.end();
      // If RemoveOldImages() has removed an image of the object, make runs again to link the image,
      // even in a folder in which make ran before.
      const bool was_removed =
          std::any_of(removed.begin(), removed.end(), [&](const KitLog::Image& image) {
            return IsBelow(image.ocf, object.folder) || IsBelow(image.file, object.folder);
          });
      if (has_makefile && (!is_top || was_removed))
        outcome.output += RunMakeTargets(object.folder, plan, make_).output;
    }
    outcome_.make_cause = InTermsOfOriginals(CauseOf(outcome.output), copies_);
  }
  outcome_.is_made = outcome.is_good;
  const std::vector<ObjectFolder> rest = NotBuilt();
  if (rest.empty() || !SomeImageIsMissing()) return;
  std::string names;
  for (const ObjectFolder& object : rest)
    names += (names.empty() ? "" : ", ") + object.folder.filename().string();
  outcome_.notes.push_back(
      fmt::format("the Makefiles made no image of {}; built without them", names));
  TryConvention(rest, plan);
}

// Returns whether a part of `image` could not be made in this build.  If so, the file of the image
// is left over from an earlier build.
bool IsOutOfDate(const KitLog::Image& image, const std::vector<KitLog::Failure>& failures) {
  return std::any_of(failures.begin(), failures.end(), [&](const KitLog::Failure& failure) {
    if (failure.file == image.ocf || failure.output == image.file) return true;
    return std::any_of(image.parts.begin(), image.parts.end(), [&](const std::string& part) {
      if (part == failure.output) return true;
      const std::vector<std::string> members = ArchiveMembers(part);
      return std::find(members.begin(), members.end(),
                       fs::path(failure.output).filename().string()) != members.end();
    });
  });
}

// Returns the sources and headers that lie in no object's folder, so that any object may use them.
std::vector<fs::path> SharedFiles(const Project& project) {
  std::vector<fs::path> files = project.shared_sources;
  for (const fs::path& folder : project.header_folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (IsHeaderName(entry.path())) files.push_back(entry.path());
  }
  return files;
}

// Returns whether `image` is older than a source or header in the folder of its .ocf file, or than
// one of the files `shared`.
bool IsOlderThanSources(const KitLog::Image& image, const std::vector<fs::path>& shared) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(image.file, error);
  std::vector<fs::path> files = FilesBelow(fs::path(image.ocf).parent_path());
  std::erase_if(files,
                [](const fs::path& file) { return !IsSourceName(file) && !IsHeaderName(file); });
  files.insert(files.end(), shared.begin(), shared.end());
  return std::any_of(files.begin(), files.end(),
                     [&](const fs::path& file) { return fs::last_write_time(file, error) > time; });
}

// Removes the images of earlier builds that this build could not make again, because they would
// look like images of this build.  Returns the removed images.
std::vector<KitLog::Image> FolderBuild::RemoveOldImages(bool is_made) {
  KitLog log = ReadKitLog(make_.log);
  // Compares the images only with shared files that exist in the user's folder.  Other shared
  // files are made by make, and may be newer than images that are up to date.
  std::vector<fs::path> shared = SharedFiles(project_);
  std::erase_if(shared,
                [&](const fs::path& file) { return !fs::exists(OriginalOf(file, copies_)); });
  // Compares the times of images and sources only if make has failed.  If make succeeds, all images
  // are newer than their sources, because make has made the older images again.
  const auto is_old = [&](const KitLog::Image& image) {
    return IsOutOfDate(image, log.failures) || (!is_made && IsOlderThanSources(image, shared));
  };
  std::vector<KitLog::Image> old;
  std::copy_if(log.images.begin(), log.images.end(), std::back_inserter(old), is_old);
  RemoveImages(old, project_);
  std::erase_if(log.images, is_old);
  WriteKitLog(make_.log, log);
  return old;
}

// Returns whether the build lacks an image that an OBJECT.CFG names.  If no stick has an
// OBJECT.CFG, nothing says which images are needed, and the function returns whether make has
// failed.
bool FolderBuild::SomeImageIsMissing() const {
  const KitLog log = ReadKitLog(make_.log);
  bool has_list = false;
  for (const StickFolder& stick : project_.sticks) {
    if (stick.objects.empty()) continue;
    has_list = true;
    // Calls CompleteStick() only to find out whether images are missing.  Then removes the images
    // that CompleteStick() has put on the stick.
    const CompletedStick completed = CompleteStick(stick, project_, log, sdk_root_, {});
    for (const fs::path& file : completed.placed) fs::remove(file);
    if (!completed.problems.empty()) return true;
  }
  return !has_list && !outcome_.is_made;
}

void FolderBuild::TryConvention(const std::vector<ObjectFolder>& objects, const MakePlan& plan) {
  std::vector<std::string> problems;
  ShowBuildProgress(
      &make_, [&] { return CountByConvention(project_, objects); },
      [&] { problems = BuildByConvention(project_, objects, plan, work_ / "build", make_); });
  outcome_.start_problems.insert(outcome_.start_problems.end(), problems.begin(), problems.end());
}

void FolderBuild::Deliver() {
  // Scans the folders of the program again, because the rules of Makefiles may have made Memory
  // Sticks in them.
  Project after = ScanProject(copied_folders_);
  if (after.sticks.empty()) after.sticks.push_back({after.root / "MS", {}, {}});
  outcome_.wants_all = std::all_of(after.sticks.begin(), after.sticks.end(),
                                   [](const StickFolder& stick) { return stick.objects.empty(); });
  // Makes no stick if no stick has an OBJECT.CFG (`wants_all`) and an object has failed, because
  // CompleteStick() would write an OBJECT.CFG without the image of that object.
  if (outcome_.wants_all && report_->HasFailed(outcome_)) return;
  const KitLog log = ReadKitLog(make_.log);
  std::string placed;
  std::set<std::string> used;
  size_t good = 0;
  for (const StickFolder& stick : after.sticks) {
    const CompletedStick completed =
        CompleteStick(stick, after, log, sdk_root_, OriginalName(stick.root));
    for (const fs::path& file : completed.placed) placed += file.string() + "\n";
    used.insert(completed.used.begin(), completed.used.end());
    const fs::path name = stick.root.lexically_relative(after.root);
    fs::path target = OriginalName(stick.root);
    if (!options_.output.empty()) {
      target = fs::absolute(options_.output);
      if (after.sticks.size() > 1) target /= name;
    }
    const auto failed =
        DeliverStick(stick, target, *copy_, work_ / "robot" / name, !options_.output.empty());
    outcome_.problems.insert(outcome_.problems.end(), failed.begin(), failed.end());
    const bool has_own = std::any_of(completed.images.begin(), completed.images.end(),
                                     [](const PlacedImage& i) { return !i.object.empty(); });
    if (after.sticks.size() > 1 && !has_own) {
      outcome_.notes.push_back(
          fmt::format("{}: nothing built here is on this stick", target.string()));
      continue;
    }
    good += has_own;
    outcome_.sticks.push_back(target.lexically_normal());
    for (const PlacedImage& image : completed.images)
      PrintPlain("{:12} {:24} {}\n", image.name, image.object, image.from);
    outcome_.notes.insert(outcome_.notes.end(), completed.notes.begin(), completed.notes.end());
    outcome_.missing.insert(outcome_.missing.end(), completed.problems.begin(),
                            completed.problems.end());
  }
  for (const KitLog::Image& image : log.images) {
    if (!used.contains(image.file))
      outcome_.notes.push_back(
          fmt::format("{} was built, but OBJECT.CFG does not name it", image.object));
  }
  if (good == 0 && outcome_.missing.empty()) outcome_.missing.push_back("no image was made");
  WriteText(work_ / "placed.txt", placed);
}

std::string FolderBuild::OriginalName(const std::string& file) const {
  const std::string original = OriginalOf(file, copies_);
  return original.empty() ? file : original;
}

}  // namespace

int BuildFolder(const BuildOptions& options) {
  if (const std::string problem = VariantProblem(options.variant); !problem.empty())
    throw std::runtime_error(problem);
  std::error_code error;
  if (!fs::is_directory(options.folder, error)) {
    throw std::runtime_error(
        fmt::format("{}: is no folder; name the one that holds the objects", options.folder));
  }
  return FolderBuild(options).Run();
}

}  // namespace openr_host
