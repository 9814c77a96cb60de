#include "openr/kit/convention_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "openr/kit/image_match.h"
#include "openr/kit/kit_log.h"
#include "openr/kit/sdk_paths.h"
#include "openr/kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

// File names, without folders, that a source or header includes.
std::vector<std::string> IncludedNames(const fs::path& file) {
  static const std::regex kInclude("(?:^|\n)[ \t]*#[ \t]*include[ \t]*[\"<]([^\">\n]+)[\">]");
  const std::string text = ReadText(file).value_or("");
  std::vector<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
    std::string name = (*it)[1];
    std::replace(name.begin(), name.end(), '\\', '/');
    names.push_back(LowerCase(fs::path(name).filename()));
  }
  return names;
}

// Headers with a name, wherever the project keeps them.
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

// A program of its own, not part of an object.
bool HasMain(const fs::path& source) {
  static const std::regex kMain("(?:^|\n)[ \t]*(?:(?:int|void)[ \t\r\n]+)?main[ \t]*\\(");
  return std::regex_search(ReadText(source).value_or(""), kMain);
}

std::string Joined(const Paths& paths) {
  std::string text;
  for (const fs::path& path : paths) text += " " + path.string();
  return text;
}

// The .ocf file of an object, or "" and why.
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

class ConventionBuild {
 public:
  ConventionBuild(const Project& project, const ObjectFolder& object, fs::path build,
                  const MakeOptions& options)
      : project_(project), object_(object), build_(std::move(build)), options_(options) {
    // What a first attempt left undefined is no failure if the second one succeeds.
    options_.log = build_ / "log.txt";
    for (const fs::path& source : project.shared_sources) {
      if (!HasMain(source)) shared_.push_back(source);
    }
  }

  // Returns why it cannot be tried, or "".
  std::string Run() {
    std::string problem;
    ocf_ = ChooseOcf(object_, &problem);
    if (!problem.empty()) return problem;
    RemoveStaleStub();
    const Paths included = SourcesIncluded(object_.sources, shared_);
    WriteMakefile(included, {});
    // What is undefined in a first attempt may be found in a second one.
    const bool has_more = included.size() < shared_.size();
    if (Make(has_more ? MakeOptions::Says::kIfGood : MakeOptions::Says::kAlways) || !has_more)
      return "";
    if (LinksOnly()) {
      LinkWithAll(included);
    } else {
      Make(MakeOptions::Says::kAlways);
    }
    return "";
  }

  KitLog log() const { return ReadKitLog(options_.log); }

 private:
  bool Make(MakeOptions::Says says) {
    CleanKitLog(options_.log);
    options_.says = says;
    return RunMakeIn(build_, {}, options_);
  }

  // Whether all that is wrong is that something is undefined.
  bool LinksOnly() const {
    const std::vector<KitLog::Failure> failures = log().failures;
    return !failures.empty() &&
           std::all_of(failures.begin(), failures.end(), [](const KitLog::Failure& failure) {
             return failure.why.find("undefined") != std::string::npos;
           });
  }

  // Sources that nobody includes a header of; those that do not compile were not meant.
  void LinkWithAll(const Paths& included) {
    Paths rest, compiling;
    std::set_difference(shared_.begin(), shared_.end(), included.begin(), included.end(),
                        std::back_inserter(rest));
    for (const fs::path& source : rest) {
      WriteMakefile(included, {source});
      MakeOptions quiet = options_;
      quiet.says = MakeOptions::Says::kNever;
      const std::string object = build_.string() + "/" + source.string() + ".o";
      if (RunMakeIn(build_, {object}, quiet)) compiling.push_back(source);
    }
    WriteMakefile(included, compiling);
    Make(MakeOptions::Says::kAlways);
  }

  // Those of an earlier build on the robot would be found before ours.
  void RemoveStaleStub() const {
    if (object_.stub.empty()) return;
    std::error_code ignored;
    for (const char* name : {"def.h", "entry.h"}) fs::remove(object_.folder / name, ignored);
  }

  void WriteMakefile(const Paths& included, const Paths& more) const {
    std::string flags = "-O2 -I" + object_.folder.string();
    for (const fs::path& folder : project_.header_folders) flags += " -I" + folder.string();
    flags += " -I" + project_.root.string();
    for (const ObjectFolder& other : project_.objects) {
      if (other.folder != object_.folder) flags += " -idirafter " + other.folder.string();
    }
    WriteText(
        build_ / "Makefile",
        fmt::format(
            "OBJECT = {}\nSTUB = {}\nOCF = {}\nSOURCES ={}\nCOMMON ={}{}\n"
            "BUILD = {}\nCXXFLAGS = {}\ninclude {}\n",
            ocf_.stem().string(), object_.stub.string(), ocf_.string(), Joined(object_.sources),
            Joined(included), Joined(more), build_.string(), flags,
            (fs::path(options_.sdk_root) / "../Makefile.openr-host").lexically_normal().string()));
  }

  const Project& project_;
  const ObjectFolder& object_;
  const fs::path build_;
  MakeOptions options_;
  Paths shared_;
  fs::path ocf_;
};

}  // namespace

std::vector<fs::path> SourcesIncluded(const Paths& sources, const Paths& shared) {
  const std::multimap<std::string, fs::path> headers = HeadersByName(sources, shared);
  std::set<fs::path> found, seen(sources.begin(), sources.end());
  Paths todo = sources;
  while (!todo.empty()) {
    const fs::path file = todo.back();
    todo.pop_back();
    for (const std::string& name : IncludedNames(file)) {
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

std::vector<std::string> BuildByConvention(const Project& project,
                                           const std::vector<ObjectFolder>& objects,
                                           const fs::path& work, const MakeOptions& options) {
  std::vector<std::string> problems;
  for (const ObjectFolder& object : objects) {
    const fs::path build = work / object.folder.lexically_relative(project.root);
    ConventionBuild attempt(project, object, build.lexically_normal(), options);
    const std::string problem = attempt.Run();
    AppendKitLog(options.log, attempt.log());
    if (!problem.empty()) {
      problems.push_back(fmt::format("{}: {}", object.folder.filename().string(), problem));
    }
  }
  return problems;
}

}  // namespace openr_host
