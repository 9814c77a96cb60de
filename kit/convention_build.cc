#include "kit/convention_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "cli/process.h"
#include "kit/image_match.h"
#include "kit/kit_log.h"
#include "kit/make_flags.h"
#include "kit/sdk_paths.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

// Returns the headers that lie in the same folders as `sources` and `shared`.  The key is the file
// name in lower case, because #include lines may write the name with other upper and lower case
// letters.
std::multimap<std::string, fs::path> HeadersByName(const Paths& sources, const Paths& shared) {
  std::set<fs::path> folders;
  for (const fs::path& file : sources) folders.insert(file.parent_path());
  for (const fs::path& file : shared) folders.insert(file.parent_path());
  std::multimap<std::string, fs::path> headers;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (IsHeaderName(entry.path()))
        headers.emplace(LowerCase(entry.path().filename()), entry.path());
    }
  }
  return headers;
}

// Returns whether the source has a main().  Such a source is a program of its own and no part of an
// object.
bool HasMain(const fs::path& source) {
  static const std::regex kMain("(?:^|\n)[ \t]*(?:(?:int|void)[ \t\r\n]+)?main[ \t]*\\(");
  return std::regex_search(ReadText(source).value_or(""), kMain);
}

// Returns the shared sources, which lie in no object's folder.  Leaves out sources with a main(),
// because such a source is a program of its own.
Paths SharedParts(const Project& project) {
  Paths shared;
  for (const fs::path& source : project.shared_sources)
    if (!HasMain(source)) shared.push_back(source);
  return shared;
}

std::string Joined(const Paths& paths) {
  std::string text;
  for (const fs::path& path : paths) text += " " + path.string();
  return text;
}

// Returns the .ocf file of an object.  If the object has several .ocf files, returns the file whose
// name is most like the name of the object's class or folder.  If no .ocf file fits, returns "" and
// sets `problem` to the error message.
fs::path ChooseOcf(const ObjectFolder& object, std::string* problem) {
  if (object.ocfs.size() == 1) return object.ocfs[0];
  if (object.ocfs.empty()) {
    *problem =
        fmt::format("no .ocf file; write one line to {}: object NAME 3072 16384 128 cache tlb user",
                    (object.folder / (LowerCase(object.folder.filename()) + ".ocf")).string());
    return {};
  }
  std::vector<ImageCandidate> candidates;
  for (const fs::path& ocf : object.ocfs) candidates.push_back({{ocf.stem()}});
  const std::string wanted =
      object.class_name.empty() ? object.folder.filename().string() : object.class_name;
  const int match = MatchImages({wanted + ".BIN"}, candidates)[0];
  if (match >= 0) return object.ocfs[static_cast<size_t>(match)];
  *problem =
      fmt::format("{} .ocf files, none named like '{}'; leave one", object.ocfs.size(), wanted);
  return {};
}

// Returns `word`, a word of a shell command, with '$' and '#' escaped, because these characters
// have a meaning for make.
std::string InMakefile(const std::string& word) {
  std::string text;
  for (const char c : word) {
    if (c == '$') text += '$';
    if (c == '#') text += '\\';
    text += c;
  }
  return text;
}

// Returns whether the def.h beside the stub.cfg was written by hand, not by stubgen2.
bool HasOwnDefinitions(const ObjectFolder& object) {
  const auto text = ReadText(object.folder / "def.h");
  return text && !IsGeneratedDefinitions(*text);
}

// Returns the folder, inside the object's folder, from which the object's sources include the stub,
// as in `#include "stub/def.h"`; "" if they name no such folder.  A folder with a stub.cfg, or with
// a def.h written by hand, does not count.
fs::path NamedStubFolder(const ObjectFolder& object) {
  static const std::regex kInclude(
      "(?:^|\n)[ \t]*#[ \t]*include[ \t]*[\"<]([^\">\n]+)/(?:def|entry)\\.h[\">]");
  std::error_code error;
  for (const fs::path& file : FilesBelow(object.folder)) {
    if (!IsSourceName(file) && !IsHeaderName(file)) continue;
    const std::string text = ReadText(file).value_or("");
    for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
      const std::string name = (*it)[1];
      const bool is_object = !FindEntry(file.parent_path() / name, "stub.cfg").empty() ||
                             !FindEntry(object.folder.parent_path() / name, "stub.cfg").empty();
      const fs::path folder = (file.parent_path() / name).lexically_normal();
      const auto there = ReadText(folder / "def.h");
      const bool is_free = !there || IsGeneratedDefinitions(*there);
      if (!is_object && is_free && IsBelow(folder, object.folder)) return folder;
    }
  }
  return {};
}

// Returns the folder into which stubgen2 writes the stub of `object`: the folder from which the
// object's sources include the stub.  If the sources name no such folder, returns the folder of
// stub.cfg, because sources of other objects may include the stub from that folder
// ("../Walker/def.h").  If the folder of stub.cfg has a def.h written by hand, returns `build`, so
// that this def.h is not overwritten.
fs::path StubFolder(const ObjectFolder& object, const fs::path& build) {
  const fs::path named = NamedStubFolder(object);
  if (!named.empty()) return named;
  return HasOwnDefinitions(object) ? build : object.folder;
}

// Runs stubgen2 for the stub.cfg of `object`, unless the stub is newer than its stub.cfg.  Shows no
// errors in stub.cfg, because the build of the object reports them later.
void GenerateStub(const ObjectFolder& object, const MakeOptions& options) {
  const fs::path folder = StubFolder(object, {});
  if (object.stub.empty() || folder.empty()) return;
  std::error_code error;
  const auto made = fs::last_write_time(folder / "def.h", error);
  if (!error && made > fs::last_write_time(object.stub, error)) return;
  fs::create_directories(folder, error);
  RunProcess({options.sdk_root + "/OPEN_R/bin/stubgen2", object.stub, "-o", folder},
             {{}, "", true, true, false, true});
}

class ConventionBuild {
 public:
  // Prepares the build of `object`.  `flags` are compiler flags from the object's Makefile.
  ConventionBuild(const Project& project, const ObjectFolder& object,
                  std::vector<std::string> flags, fs::path build, const MakeOptions& options)
      : project_(project),
        object_(object),
        flags_(std::move(flags)),
        build_(std::move(build)),
        options_(options) {
    // The build of this object has a log of its own.  The names that are undefined at its first
    // attempt to link are no failure if the second attempt succeeds, so they must not be in the log
    // of the whole build.
    options_.log = build_ / "log.txt";
    shared_ = SharedParts(project);
  }

  // Builds the object.  Returns "", or the reason why the build could not begin.  Failures during
  // the build are in log().
  std::string Run() {
    std::string problem;
    ocf_ = ChooseOcf(object_, &problem);
    if (!problem.empty()) return problem;
    const Paths included = SourcesIncluded(object_.sources, shared_);
    WriteMakefile(included, {});
    // In the first attempt, links only the shared sources whose headers are included.  If there are
    // other shared sources, prints no messages of a failed first attempt, because the second
    // attempt links these sources, too, and may succeed.
    const bool has_more = included.size() < shared_.size();
    if (Make(has_more ? MakeOptions::PrintOutput::kIfGood : MakeOptions::PrintOutput::kAlways) ||
        !has_more)
      return "";
    if (HasOnlyUndefinedNames()) {
      LinkWithAll(included);
    } else {
      Make(MakeOptions::PrintOutput::kAlways);
    }
    return "";
  }

  KitLog log() const { return ReadKitLog(options_.log); }

 private:
  bool Make(MakeOptions::PrintOutput print_output) {
    CleanKitLog(options_.log);
    options_.print_output = print_output;
    return RunMakeIn(build_, {}, options_).is_good;
  }

  // Returns whether all failures of the last build are undefined names.  If so, linking more
  // sources may help.
  bool HasOnlyUndefinedNames() const {
    const std::vector<KitLog::Failure> failures = log().failures;
    return !failures.empty() &&
           std::all_of(failures.begin(), failures.end(), [](const KitLog::Failure& failure) {
             return failure.why.find("undefined") != std::string::npos;
           });
  }

  // Links the object with `included`, the shared sources whose headers the object includes, and
  // with all other shared sources that compile, because one of them may define the undefined names.
  void LinkWithAll(const Paths& included) {
    Paths rest, compiling;
    std::set_difference(shared_.begin(), shared_.end(), included.begin(), included.end(),
                        std::back_inserter(rest));
    for (const fs::path& source : rest) {
      WriteMakefile(included, {source});
      MakeOptions quiet = options_;
      quiet.print_output = MakeOptions::PrintOutput::kNever;
      const std::string object = build_.string() + "/" + source.string() + ".o";
      if (RunMakeIn(build_, {object}, quiet).is_good) compiling.push_back(source);
    }
    WriteMakefile(included, compiling);
    Make(MakeOptions::PrintOutput::kAlways);
  }

  // Returns the flags for the compiler.  Header folders from the object's Makefile come first,
  // because the Makefile names the right folders.  Other folders of the project come last, because
  // they may have different headers with the same names.
  std::string CompilerFlags() const {
    std::string flags = "-O2";
    for (const std::string& flag : flags_) flags += " " + InMakefile(ShellWord(flag));
    flags += " -I" + object_.folder.string();
    // Never gives a folder both flags, -I and -idirafter, because gcc searches such a folder last,
    // as if it had no -I.
    const auto add = [&](const fs::path& folder, const char* search) {
      const bool is_first =
          std::find(flags_.begin(), flags_.end(), "-I" + folder.string()) != flags_.end();
      if (!is_first && folder != object_.folder) flags += search + folder.string();
    };
    const char* const search = flags_.empty() ? " -I" : " -idirafter ";
    for (const fs::path& folder : project_.header_folders) add(folder, search);
    add(project_.root, search);
    for (const ObjectFolder& other : project_.objects) add(other.folder, " -idirafter ");
    return flags;
  }

  void WriteMakefile(const Paths& included, const Paths& more) const {
    WriteText(
        build_ / "Makefile",
        fmt::format(
            "OBJECT = {}\nSTUB = {}\nOCF = {}\nSOURCES ={}\nCOMMON ={}{}\n"
            "BUILD = {}\nSTUBS = {}\nCXXFLAGS = {}\ninclude {}\n",
            ocf_.stem().string(), object_.stub.string(), ocf_.string(), Joined(object_.sources),
            Joined(included), Joined(more), build_.string(), StubFolder(object_, build_).string(),
            CompilerFlags(),
            (fs::path(options_.sdk_root) / "../Makefile.openr-host").lexically_normal().string()));
  }

  const Project& project_;
  const ObjectFolder& object_;
  const std::vector<std::string> flags_;
  const fs::path build_;
  MakeOptions options_;
  Paths shared_;
  fs::path ocf_;
};

}  // namespace

std::vector<std::string> IncludedNames(const std::string& text) {
  static const std::regex kInclude("(?:^|\n)[ \t]*#[ \t]*include[ \t]*[\"<]([^\">\n]+)[\">]");
  std::vector<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
    std::string name = (*it)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    names.push_back(LowerCase(fs::path(name).filename()));
  }
  return names;
}

std::vector<fs::path> SourcesIncluded(const Paths& sources, const Paths& shared) {
  const std::multimap<std::string, fs::path> headers = HeadersByName(sources, shared);
  std::set<fs::path> found, seen(sources.begin(), sources.end());
  Paths todo = sources;
  while (!todo.empty()) {
    const fs::path file = todo.back();
    todo.pop_back();
    for (const std::string& name : IncludedNames(ReadText(file).value_or(""))) {
      const auto [begin, end] = headers.equal_range(name);
      for (auto it = begin; it != end; ++it) {
        if (seen.insert(it->second).second) todo.push_back(it->second);
      }
      for (const fs::path& source : shared) {
        const bool is_namesake = LowerCase(source.stem()) == fs::path(name).stem();
        if (!is_namesake && LowerCase(source.filename()) != name) continue;
        found.insert(source);
        if (seen.insert(source).second) todo.push_back(source);
      }
    }
  }
  return {found.begin(), found.end()};
}

uint64_t CountByConvention(const Project& project, const std::vector<ObjectFolder>& objects) {
  const Paths shared = SharedParts(project);
  uint64_t count = 0;
  for (const ObjectFolder& object : objects) {
    const uint64_t stubs = object.stub.empty() ? 0 : 1;
    count += object.sources.size() + stubs + SourcesIncluded(object.sources, shared).size();
  }
  return count;
}

std::vector<std::string> BuildByConvention(const Project& project,
                                           const std::vector<ObjectFolder>& objects,
                                           const MakePlan& plan, const fs::path& work,
                                           const MakeOptions& options) {
  std::vector<std::string> problems;
  // Makes the stubs of all objects first, because sources may include the stub of another object.
  for (const ObjectFolder& object : project.objects) GenerateStub(object, options);
  const KitLog made = ReadKitLog(options.log);
  for (const ObjectFolder& object : objects) {
    const fs::path build = work / object.folder.lexically_relative(project.root);
    ConventionBuild attempt(project, object,
                            FlagsOfMakefiles(object.folder, made, plan.variables, options),
                            build.lexically_normal(), options);
    const std::string problem = attempt.Run();
    KitLog log = attempt.log();
    // Removes the compilations from the log, because their flags come from the Makefile that
    // ConventionBuild has written and not from the user's Makefile.
    log.compiles.clear();
    AppendKitLog(options.log, log);
    if (!problem.empty()) {
      problems.push_back(fmt::format("{}: {}", object.folder.filename().string(), problem));
    }
  }
  return problems;
}

}  // namespace openr_host
