#include "kit/referred_places.h"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "kit/makefile_text.h"
#include "kit/text_files.h"
#include "runtime/base/assert.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Largest number of files in a folder outside of the program.  A folder with more files is not
// taken as a part of the program.
constexpr size_t kOutsideFilesMax = 20'000;

// Returns whether the file, by its name, may be a part of a program.  Other files are ignored in a
// folder that contains the program's own folder, because such a folder may hold many files that do
// not belong to the program.
bool IsPartOfPrograms(const fs::path& file) {
  return IsSourceName(file) || IsHeaderName(file) || IsMakefileName(file) ||
         LowerCase(file.extension()) == ".ocf" || LowerCase(file.extension()) == ".cfg";
}

// Largest depth of Makefiles that include other Makefiles, and of variables that contain other
// variables.  The limit ends the search if a variable contains itself.
constexpr int kDepthMax = 8;

using Variables = std::map<std::string, std::string>;

// Returns the variables of a Makefile whose value is a single path, each with the value of its
// first assignment.  The value may contain other variables.
Variables PathVariables(const std::string& makefile) {
  const std::string text = WithoutLongWords(makefile);
  static const std::regex kDefinition(
      "(?:^|\n)[ \t]*(?:export[ \t]+)?(\\w+)[ \t]*[:?]?=[ \t]*([\\w./+(){}$-]+)[ \t\r]*(?=\n|#|$)");
  Variables variables;
  for (std::sregex_iterator it(text.begin(), text.end(), kDefinition), end; it != end; ++it)
    variables.emplace((*it)[1], (*it)[2]);
  return variables;
}

std::string Expanded(const std::string& text, const Variables& variables) {
  static const std::regex kUse("\\$[({](\\w+)[)}]");
  std::string result = text;
  for (int depth = 0; depth < kDepthMax; ++depth) {
    std::string next;
    size_t done = 0;
    for (std::sregex_iterator it(result.begin(), result.end(), kUse), end; it != end; ++it) {
      const auto variable = variables.find((*it)[1]);
      if (variable == variables.end()) continue;
      next += result.substr(done, static_cast<size_t>(it->position(0)) - done) + variable->second;
      done = static_cast<size_t>(it->position(0) + it->length(0));
    }
    if (done == 0) break;
    result = next + result.substr(done);
    // Returns `text` unchanged if the values of its variables make the result very long, because
    // then a variable probably contains itself.
    if (result.size() > 100 * text.size() + 1000) return text;
  }
  return result;
}

// Returns the files that the text `makefile` includes.  The variables in `makefile` have been
// replaced by their values before.
std::vector<fs::path> IncludedFiles(const fs::path& folder, const std::string& makefile) {
  static const std::regex kInclude("(?:^|\n)[ \t]*[-s]?include[ \t]+");
  std::vector<fs::path> files;
  for (std::sregex_iterator it(makefile.begin(), makefile.end(), kInclude), end; it != end; ++it) {
    const auto begin = static_cast<size_t>(it->position(0) + it->length(0));
    std::istringstream words(makefile.substr(begin, makefile.find_first_of("#\n", begin) - begin));
    for (std::string word; words >> word;) files.push_back((folder / word).lexically_normal());
  }
  return files;
}

class PlaceSearch {
 public:
  explicit PlaceSearch(const fs::path& root) { places_.folders.push_back(root); }

  ReferredPlaces Run() {
    size_t next_folder = 0, next_file = 0;
    while (next_folder < places_.folders.size() || next_file < places_.files.size()) {
      if (next_folder < places_.folders.size()) {
        const fs::path folder = places_.folders[next_folder++];
        for (const fs::path& file : FilesBelow(folder)) Follow(file);
      } else {
        const fs::path file = places_.files[next_file++];
        Follow(file);
      }
    }
    RemoveInnerFolders();
    return std::move(places_);
  }

 private:
  void RemoveInnerFolders() {
    std::vector<fs::path> outer;
    for (const fs::path& folder : places_.folders) {
      const bool is_inner = std::any_of(
          places_.folders.begin(), places_.folders.end(),
          [&](const fs::path& other) { return other != folder && IsBelow(folder, other); });
      if (!is_inner) outer.push_back(folder);
    }
    places_.folders = std::move(outer);
  }

  void Follow(const fs::path& file) {
    if (!IsMakefileName(file) && !IsSourceName(file) && !IsHeaderName(file)) return;
    const std::string text =
        IsMakefileName(file) ? ExpandedMakefile(file) : ReadText(file).value_or("");
    if (text.find("..") == std::string::npos) return;
    for (const std::string& path : UpwardPaths(text)) {
      fs::path target = (file.parent_path() / path).lexically_normal();
      // Drops a slash at the end of the path, such as in "./", which lexically_normal() makes of
      // "a/..".  So each folder has only one spelling.
      if (!target.has_filename()) target = target.parent_path();
      AddTarget(target, path.ends_with(".."));
    }
  }

  // Adds the folder `target`, or, if `target` is a file, the folder that contains it.  `target` is
  // where a path in a file of the program leads; `is_above` tells whether this path ends in "..".
  // Adds only the files directly in the folder, and none of its folders, in two cases:
  //   - The folder contains the program's own folder, so it may hold other programs, too.
  //   - The folder contains a folder that was added before, and the path leads to a file or ends in
  //     "..".
  void AddTarget(const fs::path& target, bool is_above) {
    std::error_code error;
    if (!fs::exists(target, error) || IsCovered(target)) return;
    const bool is_folder = fs::is_directory(target, error);
    const fs::path folder = is_folder ? target : target.parent_path();
    const bool is_around_root = IsBelow(places_.folders[0], folder);
    const bool wants_files = is_above || !is_folder;
    if (is_around_root || (wants_files && ContainsReferred(folder))) {
      if (!is_folder) AddFile(target);
      AddFilesIn(folder);  // also adds headers that sources beside them name without "../"
    } else if (FilesBelow(folder).size() <= kOutsideFilesMax) {
      places_.folders.push_back(folder);
    }
  }

  void AddFilesIn(const fs::path& folder) {
    const bool is_new =
        std::find(places_.around.begin(), places_.around.end(), folder) == places_.around.end();
    if (!is_new) return;
    places_.around.push_back(folder);
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
      if (entry.is_regular_file(error) && IsPartOfPrograms(entry.path()))
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) AddFile(file);
  }

  void AddFile(const fs::path& file) {
    if (std::find(places_.files.begin(), places_.files.end(), file) == places_.files.end())
      places_.files.push_back(file);
  }

  bool IsCovered(const fs::path& path) const {
    return std::any_of(places_.folders.begin(), places_.folders.end(),
                       [&](const fs::path& folder) { return IsBelow(path, folder); });
  }
  bool ContainsReferred(const fs::path& folder) const {
    return std::any_of(places_.folders.begin(), places_.folders.end(),
                       [&](const fs::path& inner) { return IsBelow(inner, folder); });
  }

  ReferredPlaces places_;
};

}  // namespace

std::string ExpandedMakefile(const fs::path& file) {
  std::string text = ReadText(file).value_or("");
  std::set<fs::path> seen{file};
  for (int depth = 0; depth < kDepthMax; ++depth) {
    bool is_more = false;
    for (const fs::path& included :
         IncludedFiles(file.parent_path(), Expanded(text, PathVariables(text)))) {
      if (!seen.insert(included).second) continue;
      text += "\n" + ReadText(included).value_or("");
      is_more = true;
    }
    if (!is_more) break;
  }
  return Expanded(text, PathVariables(text));
}

ReferredPlaces FindReferredPlaces(const fs::path& root) {
  ASSERT(root.is_absolute(), "{}", root.string());
  return PlaceSearch(root).Run();
}

}  // namespace openr_host
