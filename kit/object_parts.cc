#include "kit/object_parts.h"

#include <algorithm>
#include <deque>

#include "kit/convention_build.h"
#include "kit/image_match.h"
#include "kit/makefile_text.h"
#include "kit/source_text.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

bool IsCode(const fs::path& file) { return IsSourceName(file) || IsHeaderName(file); }
bool IsOcf(const fs::path& file) { return LowerCase(file.extension()) == ".ocf"; }

bool IsMadeByStubgen(const fs::path& file, const ObjectFolder& object) {
  const std::string name = file.filename();
  return name == "def.h" || name == "entry.h" ||
         (!object.class_name.empty() && file.stem() == object.class_name + "Stub");
}

// Returns the relative paths that a Makefile names: the paths with "../", and all other words that
// contain a slash and do not begin with a slash.
std::vector<std::string> PathsIn(const std::string& makefile) {
  std::vector<std::string> paths = UpwardPaths(makefile);
  std::string word;
  for (const char c : makefile + " ") {
    const bool is_path = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                         std::string_view("/._+-").find(c) != std::string_view::npos;
    if (is_path) {
      word += c;
      continue;
    }
    if (word.starts_with("-I")) word.erase(0, 2);
    const bool is_relative = word.find('/') != std::string::npos && word[0] != '/';
    if (is_relative && !word.starts_with("..")) paths.push_back(word);
    word.clear();
  }
  return paths;
}

}  // namespace

ObjectParts::ObjectParts(const Project& project, const ReferredPlaces& places) : project_(project) {
  for (const auto* objects : {&project.objects, &project.neighbours}) {
    for (const ObjectFolder& object : *objects) object_folders_.insert(object.folder);
  }
  for (const fs::path& folder : places.folders) {
    for (const fs::path& file : FilesBelow(folder)) AddFile(file);
  }
  for (const fs::path& file : places.files) AddFile(file);
}

void ObjectParts::AddFile(const fs::path& file) {
  all_.push_back(file);
  if (IsMakefileName(file)) makefiles_.push_back(file);
  if (IsCode(file)) by_name_.emplace(LowerCase(file.filename()), file);
  if (IsSourceName(file)) by_stem_.emplace(LowerCase(file.stem()), file);
}

const std::string& ObjectParts::TextOf(const fs::path& file) const {
  const auto [entry, is_new] = texts_.emplace(file, "");
  if (!is_new) return entry->second;
  entry->second = IsMakefileName(file) ? ExpandedMakefile(file) : ReadText(file).value_or("");
  return entry->second;
}

// Returns whether `file` belongs to an object other than `object`.  Goes from the folder of the
// file to the folder above it, and so on.  The first folder of an object on this way decides.  For
// example, Cat/src/Tail.cc belongs to Cat and not to Dog.  A folder that contains the folder of
// `object` does not count, because its files may belong to both objects: if P and P/Dog are
// objects, P/Tail.cc may be part of Dog.
bool ObjectParts::BelongsToOtherThan(const fs::path& file, const ObjectFolder& object) const {
  for (fs::path folder = file.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (folder == object.folder) return false;
    if (object_folders_.contains(folder) && !IsBelow(object.folder, folder)) return true;
  }
  return false;
}

// Returns the Makefiles that build `object`: the Makefiles in its folder, and Makefiles elsewhere
// that name this folder and no folder of another object.
std::vector<fs::path> ObjectParts::MakefilesOf(const ObjectFolder& object) const {
  Paths found;
  for (const fs::path& file : makefiles_) {
    if (IsBelow(file, object.folder) && !BelongsToOtherThan(file, object)) {
      found.push_back(file);
      continue;
    }
    if (BelongsToOtherThan(file, object)) continue;
    std::set<fs::path> named;
    for (const std::string& path : PathsIn(TextOf(file))) {
      // Adds a slash and removes it again, so that "Dog" and "Dog/" become the same path.
      const fs::path target = (file.parent_path() / path / "").lexically_normal().parent_path();
      if (object_folders_.contains(target)) named.insert(target);
      if (object_folders_.contains(target.parent_path())) named.insert(target.parent_path());
    }
    if (named.size() == 1 && *named.begin() == object.folder) found.push_back(file);
  }
  return found;
}

// Returns the files that `makefiles` name, and the files directly in folders that they name.
std::vector<fs::path> ObjectParts::NamedBy(const Paths& makefiles) const {
  std::set<fs::path> named;
  for (const fs::path& makefile : makefiles) {
    for (const std::string& path : PathsIn(TextOf(makefile)))
      named.insert((makefile.parent_path() / path / "").lexically_normal().parent_path());
  }
  Paths found;
  for (const fs::path& file : all_) {
    if (named.contains(file) || named.contains(file.parent_path())) found.push_back(file);
  }
  return found;
}

const std::vector<fs::path>& ObjectParts::CodeOf(const ObjectFolder& object) const {
  const auto [entry, is_new] = code_.emplace(object.folder, Paths());
  if (is_new) entry->second = FindCode(object);
  return entry->second;
}

std::vector<fs::path> ObjectParts::FindCode(const ObjectFolder& object) const {
  std::set<fs::path> parts;
  std::deque<fs::path> todo;
  const auto add = [&](const fs::path& file) {
    if (!IsCode(file) || IsMadeByStubgen(file, object) || !parts.insert(file).second) return;
    todo.push_back(file);
  };
  for (const fs::path& file : NamedBy(MakefilesOf(object))) add(file);
  for (const fs::path& file : all_) {
    if (BelongsToOtherThan(file, object)) continue;
    const bool is_own = IsBelow(file, object.folder);
    const bool is_of_class = !is_own && !object.class_name.empty() && IsCode(file) &&
                             HasWord(TextOf(file), object.class_name);
    if (is_own || is_of_class) add(file);
  }
  // Follows #include lines.  Finds a header by its file name in any folder, because the include
  // paths of the Makefile are not known here.
  while (!todo.empty()) {
    const fs::path file = todo.front();
    todo.pop_front();
    for (const std::string& name : IncludedNames(TextOf(file))) {
      const auto add_all = [&](const auto& range) {
        for (auto it = range.first; it != range.second; ++it) {
          if (!BelongsToOtherThan(it->second, object)) add(it->second);
        }
      };
      add_all(by_name_.equal_range(name));
      // Adds sources with the name of an included header, because they also belong to the object:
      // Util.cc for Util.h.
      add_all(by_stem_.equal_range(fs::path(name).stem()));
    }
  }
  return {parts.begin(), parts.end()};
}

std::vector<fs::path> ObjectParts::OcfsOf(const ObjectFolder& object) const {
  if (!object.ocfs.empty()) return object.ocfs;
  Paths named;
  for (const fs::path& file : NamedBy(MakefilesOf(object))) {
    if (IsOcf(file)) named.push_back(file);
  }
  if (!named.empty()) return named;
  // Returns no files if there are no Makefiles, because then nothing says to which object an .ocf
  // file outside of the objects' folders belongs.
  if (makefiles_.empty()) return {};
  Paths free;
  for (const fs::path& file : all_) {
    if (IsOcf(file) && !object_folders_.contains(file.parent_path())) free.push_back(file);
  }
  std::vector<ImageCandidate> candidates;
  for (const fs::path& file : free)
    candidates.push_back({{file.filename(), file.parent_path().filename().string() + "."}});
  // Matches the .ocf files outside of the objects' folders with all objects that have no .ocf file,
  // and not only with `object`, so that two objects do not get the same file.
  std::vector<std::string> wanted;
  size_t own = 0;
  for (const ObjectFolder& other : project_.objects) {
    if (!other.ocfs.empty()) continue;
    if (other.folder == object.folder) own = wanted.size();
    wanted.push_back(
        (other.class_name.empty() ? other.folder.filename().string() : other.class_name) + ".BIN");
  }
  if (wanted.empty()) return {};
  const int match = MatchImages(wanted, candidates)[own];
  return match < 0 ? Paths() : Paths{free[static_cast<size_t>(match)]};
}

bool ObjectParts::IsForRemoteProcessing(const ObjectFolder& object) const {
  const Paths makefiles = MakefilesOf(object);
  return std::any_of(makefiles.begin(), makefiles.end(), [&](const fs::path& file) {
    return TextOf(file).find("rp-openr") != std::string::npos;
  });
}

std::vector<std::string> ObjectParts::ImageNamesOf(const ObjectFolder& object) const {
  std::vector<std::string> names = object.image_names;
  for (const fs::path& file : MakefilesOf(object)) {
    for (const std::string& name : InstalledImages(TextOf(file))) names.push_back(name);
  }
  return names;
}

bool ObjectParts::MakefilesName(const std::string& file_name) const {
  const std::string name = LowerCase(file_name);
  return std::any_of(makefiles_.begin(), makefiles_.end(), [&](const fs::path& file) {
    const std::string text = LowerCase(TextOf(file));
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
      if (at == 0 || !IsWordCharacter(text[at - 1])) return true;
    }
    return false;
  });
}

std::vector<std::string> ObjectParts::AllImageNames() const {
  std::vector<std::string> names;
  for (const fs::path& file : makefiles_) {
    for (const std::string& name : InstalledImages(TextOf(file))) names.push_back(name);
  }
  return names;
}

bool ObjectParts::HasUnreadableInstall() const {
  return std::any_of(makefiles_.begin(), makefiles_.end(), [&](const fs::path& file) {
    const std::string text = LowerCase(TextOf(file));
    return text.find("objs/$") != std::string::npos || text.find("objs)/$") != std::string::npos;
  });
}

fs::path ObjectParts::FindFile(const std::string& name) const {
  const std::string wanted = LowerCase(name);
  for (const fs::path& file : all_) {
    const bool is_on_stick = LowerCase(file).find("/open-r/") != std::string::npos;
    if (!is_on_stick && LowerCase(file.filename()) == wanted) return file;
  }
  return {};
}

}  // namespace openr_host
