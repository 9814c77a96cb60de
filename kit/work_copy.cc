#include "kit/work_copy.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

#include "cli/cache_folder.h"
#include "cli/process.h"
#include "kit/foreign_code.h"
#include "kit/makefile_text.h"
#include "kit/project.h"
#include "kit/referred_places.h"
#include "kit/text_files.h"
#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/image_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

constexpr char kLeftOutFile[] = "left_out.txt";

// Returns whether the file is an image for this host, which an earlier build has put on the stick.
bool IsBuiltImage(const fs::path& file) {
  const std::string folder = LowerCase(file.parent_path().filename());
  return folder == "objs" && LowerCase(file.extension()) == ".bin" &&
         ReadImageFile(file).problem.empty();
}

// Returns whether the file is a list of dependencies for make.  Such a list names headers of the
// robot's compiler, and make would fail without these headers.  So the private copy of the user's
// folder gets an empty file in place of the list.
bool IsDependencyList(const fs::path& file) {
  const std::string name = file.filename();
  return file.extension() == ".d" || name == ".depend" || name == ".depends" || name == ".dep";
}

// Returns whether the file has the name of a file that stubgen2 makes, and a stub.cfg is beside it.
bool IsGeneratedStub(const fs::path& file) {
  const std::string name = file.filename();
  const bool looks_so =
      name == "def.h" || name == "entry.h" || name.ends_with("Stub.cc") || name.ends_with("Stub.h");
  return looks_so && !FindEntry(file.parent_path(), "stub.cfg").empty();
}

void SetTime(const fs::path& file, const fs::path& like) {
  std::error_code error;
  fs::last_write_time(file, fs::last_write_time(like, error), error);
}

void SetOldTime(const fs::path& file) {
  const timespec times[2] = {{1, 0}, {1, 0}};
  utimensat(AT_FDCWD, file.c_str(), times, 0);
}

bool IsText(const std::string& text) {
  return text.substr(0, 4096).find('\0') == std::string::npos;
}

// Returns whether AdaptMakefile() must change paths in the copy of `file`, because the file is a
// Makefile, or a script that Makefiles may call.
bool IsToBeAdapted(const fs::path& file, const std::string& text) {
  const std::string extension = file.extension();
  const bool is_script = extension == ".sh" || extension == ".in" || file.filename() == "configure";
  return (IsMakefileName(file) || is_script || text.starts_with("#!")) && IsText(text);
}

// Returns whether `file` is a header, or a stub.cfg, from which headers are made.
bool MakesHeaders(const fs::path& file) {
  return IsHeaderName(file) || LowerCase(file.filename()) == "stub.cfg";
}

}  // namespace

WorkCopy::WorkCopy(fs::path work, std::string sdk_root)
    : work_(std::move(work)), sdk_root_(std::move(sdk_root)) {
  std::istringstream copied(ReadText(work_ / "copied.txt").value_or(""));
  for (std::string line; std::getline(copied, line);) {
    std::istringstream words(line);
    Stamp stamp;
    std::string name;
    if (words >> stamp.size >> stamp.time_ns && std::getline(words >> std::ws, name))
      former_[name] = stamp;
  }
  std::istringstream left_out(ReadText(work_ / kLeftOutFile).value_or(""));
  for (std::string file, processor;
       std::getline(left_out, file, '\t') && std::getline(left_out, processor);)
    former_left_out_[file] = processor;
}

void WorkCopy::Save() const {
  std::string text;
  for (const auto& [name, stamp] : present_)
    text += fmt::format("{} {} {}\n", stamp.size, stamp.time_ns, name);
  std::string left_out;
  for (const auto& [name, processor] : left_out_) left_out += name + "\t" + processor + "\n";
  std::string problem = WriteText(work_ / "copied.txt", text);
  if (problem.empty()) problem = WriteText(work_ / kLeftOutFile, left_out);
  if (!problem.empty()) throw std::runtime_error(problem);
}

fs::path WorkCopy::PlaceOf(const fs::path& original) const {
  for (const SourceCopy& entry : copies_) {
    if (IsBelow(original, entry.original))
      return fs::path(entry.copy) / original.lexically_relative(entry.original);
  }
  return work_ / "src" / WithoutOddCharacters(original.relative_path());
}

bool WorkCopy::IsOriginal(const fs::path& file) const {
  const auto found = present_.find(OriginalOf(file, copies_));
  return found != present_.end() && StampOf(file) == found->second;
}

fs::path WorkCopy::Add(const fs::path& original) {
  ASSERT(original.is_absolute(), "{}", original.string());
  const ReferredPlaces places = FindReferredPlaces(original);
  for (const fs::path& folder : places.folders) AddFolder(folder);
  for (const fs::path& file : places.files) CopyFile(file);
  MakeStubsAnew();
  for (const fs::path& folder : places.around) copies_.push_back({PlaceOf(folder), folder});
  RemoveVanished();
  if (has_new_headers_) RemoveObjectFiles();
  Save();
  return copies_[0].copy;
}

// Removes object files and libraries that earlier builds have made in the copy, so that all sources
// are compiled again.  Called when a header has changed, or a stub.cfg, from which headers are
// made, because the rules of a Makefile often do not name the headers (field-notes.md 1.7).  Keeps
// files that are also in the user's folder.  Does not follow links, because a link may lead out of
// the copy.
void WorkCopy::RemoveObjectFiles() const {
  std::error_code error;
  std::vector<fs::path> made;
  for (fs::recursive_directory_iterator it(work_ / "src", error), end; !error && it != end;
       it.increment(error)) {
    const std::string extension = LowerCase(it->path().extension());
    if (extension != ".o" && extension != ".a") continue;
    if (it->is_regular_file(error) && !present_.contains(OriginalOf(it->path(), copies_)))
      made.push_back(it->path());
  }
  for (const fs::path& file : made) fs::remove(file, error);
}

bool WorkCopy::IsCovered(const fs::path& original) const {
  return std::any_of(copies_.begin(), copies_.end(),
                     [&](const SourceCopy& entry) { return IsBelow(original, entry.original); });
}

void WorkCopy::AddFolder(const fs::path& original) {
  const fs::path copy = PlaceOf(original).lexically_normal();
  copies_.push_back({copy, original});
  fs::create_directories(copy);
  for (const fs::path& file : FilesBelow(original)) {
    // Leaves out the work folder, which may be inside the user's folder and would be copied into
    // itself.
    if (!IsBelow(file, work_)) CopyFile(file);
  }
  // Creates all folders in the private copy, also empty ones, because rules of Makefiles write into
  // them.
  std::error_code error;
  for (fs::recursive_directory_iterator it(original, error), end; !error && it != end;
       it.increment(error)) {
    if (!it->is_directory(error)) continue;
    if (IsIgnoredFolder(it->path()) || IsBelow(it->path(), work_)) {
      it.disable_recursion_pending();
    } else {
      fs::create_directories(PlaceOf(it->path()));
    }
  }
}

void WorkCopy::CopyFile(const fs::path& original) {
  const fs::path copy = PlaceOf(original);
  const Stamp stamp = StampOf(original);
  const auto former = former_.find(original);
  present_[original] = stamp;
  if (former != former_.end() && former->second == stamp) {
    if (const auto entry = former_left_out_.find(original); entry != former_left_out_.end())
      left_out_.insert(*entry);
    return;
  }
  if (MakesHeaders(original)) has_new_headers_ = true;
  // Does not copy files for another processor, such as the robot's, because make would treat them
  // as up to date and not build them for the host.
  const std::string processor = ForeignProcessorOf(original);
  if (!processor.empty()) {
    left_out_[original] = processor;
    return;
  }
  if (IsBuiltImage(original)) return;
  fs::create_directories(copy.parent_path());
  std::string text = IsDependencyList(original) ? "" : ReadText(original).value_or("");
  if (IsToBeAdapted(original, text)) text = AdaptMakefile(text, sdk_root_);
  const std::string problem = WriteText(copy, text);
  if (!problem.empty()) throw std::runtime_error(problem);
  std::error_code error;
  fs::permissions(copy, fs::status(original, error).permissions() | fs::perms::owner_write, error);
  SetTime(copy, original);
  // Gives the copy of a generated stub an older time than its stub.cfg, so that make runs the rule
  // that makes the stub.
  if (IsGeneratedStub(original)) {
    SetOldTime(copy);
    // Does not put a def.h that was written by hand into `left_stubs_`, because MakeStubsAnew()
    // would replace the file.
    if (copy.filename() != "def.h" || IsGeneratedDefinitions(text)) left_stubs_.push_back(copy);
  }
}

// Makes the copied stubs again with our stubgen2, because other versions of stubgen2 may have made
// the originals.  Does not leave this work to make, because a Makefile may have no rule for the
// stub, or may use the stub before that rule has run.
void WorkCopy::MakeStubsAnew() const {
  std::set<fs::path> folders;
  for (const fs::path& file : left_stubs_) folders.insert(file.parent_path());
  const fs::path made = work_ / "stub.tmp";
  std::error_code error;
  for (const fs::path& folder : folders) {
    fs::remove_all(made, error);
    fs::create_directories(made, error);
    RunProcess({sdk_root_ + "/OPEN_R/bin/stubgen2", FindEntry(folder, "stub.cfg"), "-o", made},
               {{}, "", true, true, false, true});
    for (const fs::path& file : left_stubs_) {
      const auto text = ReadText(made / file.filename());
      if (file.parent_path() != folder || !text) continue;
      WriteText(file, *text);
      SetOldTime(file);
    }
  }
  fs::remove_all(made, error);
}

// Removes from the private copy all files whose originals no longer exist in the user's folders.
void WorkCopy::RemoveVanished() {
  for (const auto& [name, stamp] : former_) {
    if (present_.contains(name) || !IsCovered(name)) continue;
    if (MakesHeaders(name)) has_new_headers_ = true;
    std::error_code error;
    fs::remove(PlaceOf(name), error);
  }
}

WorkCopy::Stamp WorkCopy::StampOf(const fs::path& file) {
  struct stat status;
  if (stat(file.c_str(), &status) != 0) return {};
  return {static_cast<uintmax_t>(status.st_size),
          static_cast<int64_t>(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec};
}

fs::path DefaultWorkFolder(const fs::path& folder, BuildVariant variant) {
  // Puts a hash of the path into the name of the work folder, because several folders of the user
  // may have the same name.
  Hasher hasher;
  hasher.AddText(folder.string());
  const std::string name = VariantName(variant);
  return CacheFolder() / "build" /
         fmt::format("{}-{:016x}{}{}", WithoutOddCharacters(folder.filename()), hasher.Digest(),
                     name.empty() ? "" : "-", name);
}

}  // namespace openr_host
