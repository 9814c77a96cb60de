// Finds the files that an object may be made of when a Makefile takes them from other folders than
// the object's own.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "kit/project.h"
#include "kit/referred_places.h"

namespace openr_host {

// Reads the files of a project, and the files of folders outside of the project that the project
// names with "../".  Each file is read at most once.
class ObjectParts {
 public:
  ObjectParts(const Project& project, const ReferredPlaces& places);

  // Returns the sources and headers of `object`: files in its folder, files that its Makefiles
  // name, files in folders that its Makefiles name, files that mention its class, headers that any
  // of these files includes, and sources with the same names as these headers.  A file in the
  // folder of another object counts only if a Makefile of `object` names the file or its folder.
  // Files made by stubgen2 are left out.
  const std::vector<std::filesystem::path>& CodeOf(const ObjectFolder& object) const;

  // Returns the object's .ocf files.  These are the .ocf files in its folder, or else the .ocf
  // files that its Makefiles name.  If there are no files of either kind, the result is the .ocf
  // file outside of all objects' folders whose name is most like the name of the object.
  std::vector<std::filesystem::path> OcfsOf(const ObjectFolder& object) const;

  // Returns whether the object's Makefiles compile it for the PC.  Such objects are a part of
  // Remote Processing, which lets objects run on a PC.
  bool IsForRemoteProcessing(const ObjectFolder& object) const;

  // Returns the file names of the images that rules of Makefiles put on a stick for `object` and
  // for no other object.
  std::vector<std::string> ImageNamesOf(const ObjectFolder& object) const;

  // Returns the file names of all images that rules of Makefiles put on a stick.
  std::vector<std::string> AllImageNames() const;

  // Returns whether a Makefile of the project contains this file name, ignoring upper and lower
  // case.
  bool MakefilesName(const std::string& file_name) const;

  // Returns whether a rule puts an image on a stick under a name with variables, whose values only
  // make knows.
  bool HasUnreadableInstall() const;

  // Finds a file of the project by its name, ignoring upper and lower case.  Files on sticks do not
  // count.  Returns an empty path if there is no such file.
  std::filesystem::path FindFile(const std::string& name) const;

  // Returns the text of `file`.  For a Makefile, returns the result of ExpandedMakefile(): the text
  // has the included files in it, and values in place of variables for paths.
  const std::string& TextOf(const std::filesystem::path& file) const;

 private:
  using Paths = std::vector<std::filesystem::path>;

  void AddFile(const std::filesystem::path& file);
  bool BelongsToOtherThan(const std::filesystem::path& file, const ObjectFolder& object) const;
  Paths FindCode(const ObjectFolder& object) const;
  Paths MakefilesOf(const ObjectFolder& object) const;
  Paths NamedBy(const Paths& makefiles) const;

  const Project& project_;
  Paths all_;
  Paths makefiles_;
  std::set<std::filesystem::path> object_folders_;
  // Files by their names in lower case, without folders.  `by_name_` has the sources and headers;
  // `by_stem_` has only the sources, by their names without extension.
  std::multimap<std::string, std::filesystem::path> by_name_, by_stem_;
  mutable std::map<std::filesystem::path, std::string> texts_;
  // Cache of CodeOf(): its results by the folder of the object.
  mutable std::map<std::filesystem::path, Paths> code_;
};

}  // namespace openr_host
