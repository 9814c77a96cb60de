// Files of a run that a fork of its process must not change: those of the Memory Stick, and those
// that the process has open.  The fork works with copies, which have the content at the moment of
// the fork.
#pragma once

#include <sys/types.h>

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace openr_host {

class FolderStick;

// Files and folders of a Memory Stick, with their content at some moment.
class SavedStick {
 public:
  struct SavedFile {
    bool is_folder = false;
    std::optional<std::string> content;  // content of the file; nullopt: the file did not exist
  };

  // Saves the file or folder `path` of the host under `name`, its path below the folder of the
  // stick.  Does nothing if this name was saved before.
  void Save(const std::string& name, const std::string& path);

  // Writes the saved files into the folder `folder`.  Leaves other files in this folder alone.
  // Throws std::runtime_error or std::filesystem::filesystem_error.
  void CopyTo(const std::string& folder) const;

  size_t bytes() const;
  // Returns the saved files; key: path below the folder of the stick.
  const std::map<std::string, SavedFile>& files() const { return files_; }

  // Converts these saved files to JSON with binary values, to send them to another process.
  nlohmann::json ToJson() const;
  // Returns the saved files from which ToJson() has made `json`.
  static SavedStick Of(const nlohmann::json& json);

 private:
  std::map<std::string, SavedFile> files_;
};

// Returns the files that objects have written on `stick`, with their present content.
SavedStick SaveWrittenFiles(FolderStick* stick);

// Remembers the regular files that this process has open, and the file offset of each file.  Leaves
// out standard input, output and error.
class ProcessFiles {
 public:
  // Remembers the files that this process has open now.
  ProcessFiles();

  // Opens each of the remembered files again, so that a fork does not share them with the original
  // process.  Called in the fork.  Files below the folder `stick` are replaced by the files with
  // the same names below `copy`.  Other files that are open for writing are replaced by copies in
  // the folder `temporary`.  Such a copy has only the bytes that its file had when the constructor
  // was called.  Throws std::system_error.
  void OpenAgain(const std::string& stick, const std::string& copy, const std::string& temporary);

  // Keeps the copies of written files when the fork has become a run of its own.  The copy of
  // DIR/NAME.EXT becomes DIR/NAME-2.EXT, or gets the next free number.  If the file belongs to a
  // trace, which is the folder DIR/NAME.ctf, the copy goes into a new trace, DIR/NAME-2.ctf,
  // together with the other files of the trace.  Returns the new files and traces.  Throws
  // std::system_error.
  std::vector<std::string> KeepCopies();

  // Moves the copy that OpenAgain() has made of the written file `path` to `target`.  This process,
  // a fork of the run, then goes on writing to `target`.  If `target` is "", the copy stays where
  // it is.  Returns the path of the file to which this process writes from now on.  Throws
  // std::runtime_error or std::system_error.
  std::string MoveCopy(const std::string& path, const std::string& target);

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
