#include "kit/build_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "cli/colour.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "kit/build_progress.h"
#include "kit/compile_database.h"
#include "kit/complete_stick.h"
#include "kit/convention_build.h"
#include "kit/foreign_code.h"
#include "kit/kit_log.h"
#include "kit/make_build.h"
#include "kit/project.h"
#include "kit/sdk_paths.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"
#include "kit/work_copy.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Name of a file in the folder in which `openr build` keeps its results.  The file says which
// version of our files and compilers made these results.
constexpr char kIdentityFile[] = "kit.txt";

// Name of a file in the folder in which `openr build` keeps its results.  The file contains the
// path of the user's folder that was built.
constexpr char kOwnerFile[] = "folder.txt";

// Returns a text that is different for each version of our files and of the compilers.  If the text
// has changed since the last build, the build begins anew, so that results of different versions
// are not mixed.
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
  void CheckWorkIsOurs() const;
  void Build();
  void TryConvention(const std::vector<ObjectFolder>& objects, const MakePlan& plan);
  bool HasFailure(const ObjectFolder& object) const;
  std::vector<ObjectFolder> NotBuilt() const;
  void RemoveOldImages(bool is_made);
  bool SomeImageIsMissing() const;
  void Deliver();
  bool HasFailed() const;
  void TellFailures();
  std::vector<std::string> LeftOutAndMissed() const;
  int Conclude() const;
  std::string ObjectOf(const fs::path& file) const;
  std::string Described(const KitLog::Failure& failure) const;
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
  bool is_made_ = false;              // true: all runs of make have succeeded
  std::string make_cause_;            // the reason why make failed; "": unknown
  bool wants_all_ = false;            // true: without an OBJECT.CFG, all images are wanted
  std::vector<std::string> hurdles_;  // reasons why the build of some objects could not begin
  std::vector<std::string> missing_;  // images that OBJECT.CFG names and that were not made
  std::vector<std::string> problems_;
  std::vector<std::string> notes_;
  std::vector<std::string> sticks_;  // folders of the finished sticks
};

// Throws if `work_`, the folder for private copies, is used for another folder of the user or holds
// files that no build has made.
void FolderBuild::CheckWorkIsOurs() const {
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
  CheckWorkIsOurs();
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
  CheckHasProgram(folder_);
  PrepareWork();
  copy_.emplace(work_, sdk_root_);
  copy_->Add(folder_);
  copies_ = copy_->copies();
  make_.copies = ToEnvironment(copies_);
  for (const SourceCopy& entry : copies_) copied_folders_.emplace_back(entry.copy);
  project_ = ScanProject(copied_folders_);
  CheckHasProgram(project_, folder_);
  Build();
  Deliver();
  if (options_.writes_database)
    WriteCompileDatabase(folder_, ReadKitLog(make_.log), copies_, &problems_);
  TellFailures();
  return Conclude();
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
  RemoveOldImages(outcome.is_good);
  // Runs make in the folder of each object that has no image yet, because the rule of a Makefile in
  // a folder above often loops over these folders and ends at the first object that fails.
  if (!outcome.is_good) {
    for (const ObjectFolder& object : NotBuilt()) {
      const bool has_makefile =
          std::any_of(project_.makefiles.begin(), project_.makefiles.end(), [&](const fs::path& f) {
            return f.parent_path() == object.folder && IsMainMakefileName(f);
          });
      const bool is_top =
          std::find(plan.folders.begin(), plan.folders.end(), object.folder) != plan.folders.end();
      if (has_makefile && !is_top)
        outcome.output += RunMakeTargets(object.folder, plan, make_).output;
    }
    make_cause_ = InTermsOfOriginals(CauseOf(outcome.output), copies_);
  }
  is_made_ = outcome.is_good;
  const std::vector<ObjectFolder> rest = NotBuilt();
  if (rest.empty() || !SomeImageIsMissing()) return;
  std::string names;
  for (const ObjectFolder& object : rest)
    names += (names.empty() ? "" : ", ") + object.folder.filename().string();
  notes_.push_back(fmt::format("the Makefiles made no image of {}; built without them", names));
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

// Returns whether a source beside the .ocf file of `image` is newer than the image.
bool IsOlderThanSources(const KitLog::Image& image) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(image.file, error);
  const std::vector<fs::path> files = FilesBelow(fs::path(image.ocf).parent_path());
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    return (IsSourceName(file) || IsHeaderName(file)) && fs::last_write_time(file, error) > time;
  });
}

// Removes the images of earlier builds that this build could not make again, because they would
// look like images of this build.
void FolderBuild::RemoveOldImages(bool is_made) {
  KitLog log = ReadKitLog(make_.log);
  // Compares the times of images and sources only if make has failed.  If make succeeds, all images
  // are newer than their sources, because make has made the older images again.
  const auto is_old = [&](const KitLog::Image& image) {
    return IsOutOfDate(image, log.failures) || (!is_made && IsOlderThanSources(image));
  };
  std::vector<KitLog::Image> old;
  std::copy_if(log.images.begin(), log.images.end(), std::back_inserter(old), is_old);
  RemoveImages(old, project_);
  std::erase_if(log.images, is_old);
  WriteKitLog(make_.log, log);
}

// Returns whether the build lacks an image that an OBJECT.CFG names.  Without an OBJECT.CFG the
// wanted images are not known, so the result then says whether make has failed.
bool FolderBuild::SomeImageIsMissing() const {
  const KitLog log = ReadKitLog(make_.log);
  bool has_list = false;
  for (const StickFolder& stick : project_.sticks) {
    if (stick.objects.empty()) continue;
    has_list = true;
    // Completes the stick only to find out whether images are missing, and so removes the images
    // again that CompleteStick() has put on the stick.
    const CompletedStick completed = CompleteStick(stick, project_, log, sdk_root_, {});
    for (const fs::path& file : completed.placed) fs::remove(file);
    if (!completed.problems.empty()) return true;
  }
  return !has_list && !is_made_;
}

void FolderBuild::TryConvention(const std::vector<ObjectFolder>& objects, const MakePlan& plan) {
  std::vector<std::string> problems;
  ShowBuildProgress(
      &make_, [&] { return CountByConvention(project_, objects); },
      [&] { problems = BuildByConvention(project_, objects, plan, work_ / "build", make_); });
  hurdles_.insert(hurdles_.end(), problems.begin(), problems.end());
}

void FolderBuild::Deliver() {
  // Scans the folders of the program again, because the rules of Makefiles may have made Memory
  // Sticks in them.
  Project after = ScanProject(copied_folders_);
  if (after.sticks.empty()) after.sticks.push_back({after.root / "MS", {}, {}});
  wants_all_ = std::all_of(after.sticks.begin(), after.sticks.end(),
                           [](const StickFolder& stick) { return stick.objects.empty(); });
  // Makes no stick if images have failed and the user's sticks have no OBJECT.CFG: an OBJECT.CFG
  // written now would lack these images.
  if (wants_all_ && HasFailed()) return;
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
    problems_.insert(problems_.end(), failed.begin(), failed.end());
    const bool has_own = std::any_of(completed.images.begin(), completed.images.end(),
                                     [](const PlacedImage& i) { return !i.object.empty(); });
    if (after.sticks.size() > 1 && !has_own) {
      notes_.push_back(fmt::format("{}: nothing built here is on this stick", target.string()));
      continue;
    }
    good += has_own;
    sticks_.push_back(target.lexically_normal());
    for (const PlacedImage& image : completed.images)
      fmt::print("{:12} {:24} {}\n", image.name, image.object, image.from);
    notes_.insert(notes_.end(), completed.notes.begin(), completed.notes.end());
    missing_.insert(missing_.end(), completed.problems.begin(), completed.problems.end());
  }
  for (const KitLog::Image& image : log.images) {
    if (!used.contains(image.file))
      notes_.push_back(fmt::format("{} was built, but OBJECT.CFG does not name it", image.object));
  }
  if (good == 0 && missing_.empty()) missing_.push_back("no image was made");
  WriteText(work_ / "placed.txt", placed);
}

// Returns whether the build of some object has failed or could not begin.  A Makefile can ignore
// the failure of a command, so make may succeed although a file has failed.  If make succeeds, only
// failures of files in the objects' folders count, because the program may not need other files.
bool FolderBuild::HasFailed() const {
  const std::vector<KitLog::Failure> failures = ReadKitLog(make_.log).failures;
  return !hurdles_.empty() ||
         std::any_of(failures.begin(), failures.end(), [this](const KitLog::Failure& failure) {
           return !is_made_ || !ObjectOf(failure.file).empty();
         });
}

// Reports the failures of the build: as errors if an image is missing, else as notes.  A failure
// without a missing image is no error, because OBJECT.CFG says which images the program needs.  The
// reason why make failed is printed last, because people look at the end of the output first.
void FolderBuild::TellFailures() {
  const KitLog log = ReadKitLog(make_.log);
  for (const KitLog::Repair& repair : log.repairs)
    notes_.push_back(fmt::format("{}: {}", repair.place, repair.what));
  const bool is_complete = missing_.empty() && problems_.empty() && !(wants_all_ && HasFailed());
  std::vector<std::string>* const where = is_complete ? &notes_ : &problems_;
  for (const KitLog::Failure& failure : log.failures) where->push_back(Described(failure));
  where->insert(where->end(), hurdles_.begin(), hurdles_.end());
  problems_.insert(problems_.end(), missing_.begin(), missing_.end());
  if (is_complete) {
    if (!make_cause_.empty()) notes_.push_back("make failed: " + make_cause_);
    return;
  }
  const std::vector<std::string> libraries = LeftOutAndMissed();
  problems_.insert(problems_.end(), libraries.begin(), libraries.end());
  // Prints the reason why make has failed.  Leaves it out if it only says that a rule has failed
  // and the log has the failure of the compiler or linker, because that failure says more and was
  // printed before.
  if (!is_made_ && (log.failures.empty() || make_cause_.find("the rule for") != 0) &&
      !make_cause_.empty())
    problems_.push_back("make failed: " + make_cause_);
}

// Returns an error message for each object file or library for another processor that the Makefiles
// name and that the build has not made anew.  The private copy does not contain such files, because
// the host cannot use them.
std::vector<std::string> FolderBuild::LeftOutAndMissed() const {
  std::string makefiles;
  for (const fs::path& file : project_.makefiles) makefiles += ReadText(file).value_or("");
  std::vector<std::string> lines;
  for (const auto& [original, processor] : copy_->left_out()) {
    const fs::path file = original;
    std::string name = file.filename();
    std::string kind = "object file";
    if (file.extension() == ".a") {
      kind = "library";
      const std::string flag = "-l" + file.stem().string().substr(name.starts_with("lib") ? 3 : 0);
      if (makefiles.find(flag) != std::string::npos) name = flag;
    } else if (file.extension() != ".o") {
      continue;
    }
    std::error_code error;
    if (fs::exists(copy_->PlaceOf(original), error)) continue;
    if (makefiles.find(name) == std::string::npos) continue;
    lines.push_back(
        fmt::format("{}: is a {} for another processor ({}); its sources are needed to build it "
                    "for this machine",
                    original, kind, processor));
  }
  return lines;
}

std::string FolderBuild::OriginalName(const std::string& file) const {
  const std::string original = OriginalOf(file, copies_);
  return original.empty() ? file : original;
}

// Returns the name of the object whose folder contains `file`; "" if no object's folder does.
std::string FolderBuild::ObjectOf(const fs::path& file) const {
  for (const ObjectFolder& object : project_.objects) {
    const fs::path build = work_ / "build" / object.folder.lexically_relative(project_.root);
    if (IsBelow(file, object.folder) || IsBelow(file, build.lexically_normal()))
      return object.class_name.empty() ? object.folder.filename().string() : object.class_name;
  }
  return "";
}

// Returns the message for the user about `failure`: "Sender: Chat/Sender/Sender.cc does not
// compile; ..."
std::string FolderBuild::Described(const KitLog::Failure& failure) const {
  const std::string object = ObjectOf(failure.file);
  const std::string original = OriginalOf(failure.file, copies_);
  return fmt::format("{}{} {}{}", object.empty() ? "" : object + ": ",
                     original.empty() ? fs::path(failure.file).filename().string() : original,
                     failure.why,
                     failure.why.find("compile") == std::string::npos
                         ? ""
                         : "; the compiler says above what to correct");
}

int FolderBuild::Conclude() const {
  std::fflush(stdout);
  const bool has_colours = HasColours(STDERR_FILENO);
  const std::string note_begin = Coloured(Colour::kNote, "openr build: note:", has_colours);
  const std::string problem_begin = Coloured(Colour::kError, "openr build:", has_colours);
  for (const std::string& note : notes_) fmt::print(stderr, "{} {}\n", note_begin, note);
  for (const std::string& problem : problems_)
    fmt::print(stderr, "{} {}\n", problem_begin, problem);
  if (!problems_.empty()) return kExitWrong;
  for (const std::string& stick : sticks_)
    fmt::print("{} run --stick {}\n", ShellWord(ProgramCall()), ShellWord(stick));
  return kExitGood;
}

}  // namespace

int BuildFolder(const BuildOptions& options) {
  if (const std::string problem = WhyNoVariant(options.variant); !problem.empty())
    throw std::runtime_error(problem);
  std::error_code error;
  if (!fs::is_directory(options.folder, error)) {
    throw std::runtime_error(
        fmt::format("{}: is no folder; name the one that holds the objects", options.folder));
  }
  return FolderBuild(options).Run();
}

}  // namespace openr_host
