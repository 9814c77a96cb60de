// The files of a run, for a copy of the run (a fork of its process): the copy gets files of its
// own, as they were at the moment of the copy, so that it changes nothing of the original run.
#pragma once

#include <sys/types.h>

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

class FolderStick;

// Files and folders of a Memory Stick, as they were at some moment.
class SavedStick {
 public:
  // Saves the file or folder `path` of the host, which is `name` below the stick's folder, unless
  // this name was saved before.
  void Save(const std::string& name, const std::string& path);

  // Makes the files in the folder `folder` as they were saved; leaves others alone.  Throws
  // std::runtime_error or std::filesystem::filesystem_error.
  void CopyTo(const std::string& folder) const;

  size_t bytes() const;

  // Convert to and from JSON that has binary values, for another process.
  nlohmann::json ToJson() const;
  static SavedStick Of(const nlohmann::json& json);

 private:
  struct Saved {
    bool is_folder = false;
    std::optional<std::string> content;  // none: there is no such file
  };
  std::map<std::string, Saved> files_;  // by path below the stick's folder
};

// Returns the files of `stick` that objects have written, as they are now.
SavedStick SaveWrittenFiles(FolderStick* stick);

// Remembers the regular files that this process has open, with their file offsets.  Leaves out
// standard input, output and error.
class ProcessFiles {
 public:
  // Notes the files that are open now.
  ProcessFiles();

  // In a fork of the process: opens each of the files again for the fork alone.  A file below the
  // folder `stick` is replaced by the file of this name below `copy`.  Any other file that is
  // written is replaced by a copy in the folder `temporary`, which is cut to the bytes that were
  // written at the time of the constructor.  Throws std::system_error.
  void OpenAgain(const std::string& stick, const std::string& copy, const std::string& temporary);

  // Gives the copies of written files lasting places, when the fork has become a run of its own:
  // the copy of DIR/NAME.EXT becomes DIR/NAME-2.EXT, or has the next number that is free.  Returns
  // these paths.  Throws std::system_error.
  std::vector<std::string> KeepCopies();

 private:
  struct File {
    int descriptor;
    std::string path;
    int flags;
    off_t offset;
    off_t size;
    bool is_copied = false;
  };

  std::vector<File> files_;
};

}  // namespace openr_host
