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

// The files of a project and of the places it refers to, read once.
class ObjectParts {
 public:
  ObjectParts(const Project& project, const ReferredPlaces& places);

  // Sources and headers: those below the object's folder, those in folders that its Makefiles name,
  // those that mention its class, and what all of these include, with the sources beside headers.
  // Files of other objects' folders count only if a Makefile names their folder.  Files
  // that stubgen2 makes are left out.
  const std::vector<std::filesystem::path>& CodeOf(const ObjectFolder& object) const;

  // The .ocf files of its folder; else those that its Makefiles name; else, of those that lie in no
  // object's folder, the one with a name like the object's.
  std::vector<std::filesystem::path> OcfsOf(const ObjectFolder& object) const;

  // Whether its Makefiles compile it with the tools of the PC side of Remote Processing.
  bool IsForRemoteProcessing(const ObjectFolder& object) const;

  // File names of images that rules install for this object only.
  std::vector<std::string> ImageNamesOf(const ObjectFolder& object) const;

  // The same for all Makefiles and objects.
  std::vector<std::string> AllImageNames() const;

  // Whether a Makefile of the project contains this file name, in any case.
  bool MakefilesName(const std::string& file_name) const;

  // Whether some rule installs images under a name that only make can tell.
  bool HasUnreadableInstall() const;

  // Finds a file by its name, upper and lower case being equal, but not inside of a stick.  An
  // empty path if there is none.
  std::filesystem::path FindFile(const std::string& name) const;

  // The text of a file; for a Makefile the text that make reads (referred_places.h).
  const std::string& TextOf(const std::filesystem::path& file) const;

 private:
  using Paths = std::vector<std::filesystem::path>;

  void AddFile(const std::filesystem::path& file);
  bool IsOfOther(const std::filesystem::path& file, const ObjectFolder& object) const;
  Paths FindCode(const ObjectFolder& object) const;
  Paths MakefilesOf(const ObjectFolder& object) const;
  Paths NamedBy(const Paths& makefiles) const;

  const Project& project_;
  Paths all_;
  Paths makefiles_;
  std::set<std::filesystem::path> object_folders_;
  // Sources and headers by names in lower case, without folders; sources also without extension.
  std::multimap<std::string, std::filesystem::path> by_name_, by_stem_;
  mutable std::map<std::filesystem::path, std::string> texts_;
  mutable std::map<std::filesystem::path, Paths> code_;  // by object folder
};

}  // namespace openr_host
