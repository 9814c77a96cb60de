// MemoryStick: the files that objects see under /MS.
//
// Names are absolute, begin with /MS/ and use '/'.  Upper and lower case letters are equal, as in
// the robot's FAT file system.  No name leads to a file outside of the stick.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace openr_host {

class Hasher;

class MemoryStick {
 public:
  virtual ~MemoryStick() = default;

  // The place of a file or folder on the host.  `error` is 0 or an errno: ENOENT (also for names
  // outside of /MS), EINVAL (a zero byte in the name), ENAMETOOLONG (the host
  // cannot have such a path), EACCES, EIO.  A FIFO, a socket or a device gives EACCES, because the
  // robot's file system has none, and opening or reading it could wait without end.  If a file does
  // not exist but its folder does, `path` is the place to create the file, `exists` is false and
  // `error` is 0.
  struct Location {
    std::string path;
    bool exists = false;
    int error = 0;
  };
  virtual Location Locate(std::string_view name) = 0;

  // Returns the bytes of the file `name`.  Used by the runtime itself, for configuration files and
  // design data.  Returns nullopt if the file cannot be read; ReadError() then returns the reason.
  std::optional<std::string> ReadFile(std::string_view name);
  // Returns the errno of a failed ReadFile() of `name`: ENOENT if the file does not exist, EACCES
  // if the file may not be read.
  int ReadError(std::string_view name);

  // Returns the hash of the names (below /MS) and contents of the files, or 0 if there are no
  // files.  A replay compares this hash with the hash of the recording.  So the hash leaves out
  // files that may differ although the program is the same: images and debug files, which differ
  // from build to build, and the record of a crash in an earlier run.
  virtual uint64_t ContentHash() = 0;

  // Returns the names below /MS, sorted, of the FIFOs, sockets and devices that the last
  // ContentHash() has found.
  const std::vector<std::string>& special_files() const { return special_files_; }

  // Records that objects change the file `name`, so that HashState() adds its content to the state
  // hash.  Called before an object makes, writes, renames or removes the file.
  void NoteWritten(std::string_view name);

  // A function that is called before an object changes a file or folder for the first time in the
  // run.  So the function can save the file or folder in its first state.  OnFirstChange() adds
  // such a function.
  using ChangeListener = std::function<void(const Location&)>;
  void OnFirstChange(ChangeListener listener) { listeners_.push_back(std::move(listener)); }

  // Returns the names of all files and folders for which NoteWritten() was called.
  const std::set<std::string>& written() const { return written_; }

  bool writable() const { return writable_; }
  void set_writable(bool writable) { writable_ = writable; }

  // Adds to the state hash the names and contents of the files that objects have written, because
  // objects may read these files later in the run.  Files that no object has written do not change
  // during a run.
  void HashState(Hasher* hasher);

 protected:
  // Adds to `hasher` the size and the bytes of the file `name`, or the text `otherwise` if the file
  // cannot be read.
  void HashFile(std::string_view name, std::string_view otherwise, Hasher* hasher);

  std::vector<std::string> special_files_;

 private:
  bool writable_ = true;
  std::set<std::string> written_;
  std::vector<ChangeListener> listeners_;
  std::set<std::string> changed_;  // host paths for which `listeners_` were called
};

// A stick whose files are in a folder of the host.  The folder contains OPEN-R/.
class FolderStick : public MemoryStick {
 public:
  explicit FolderStick(std::string root) : root_(std::move(root)) {}
  Location Locate(std::string_view name) override;
  uint64_t ContentHash() override;
  const std::string& root() const { return root_; }
  // Makes `root` the folder of the host that has the files of this stick.  REQUIRES: `root` is a
  // copy of the previous folder.
  void set_root(std::string root) { root_ = std::move(root); }

 private:
  std::string root_;
};

// A stick for tests: call number `nth` of Locate(), counted from 1, fails with `error`.  All other
// calls go to `inner`.
class FailingStick : public MemoryStick {
 public:
  FailingStick(std::shared_ptr<MemoryStick> inner, int nth, int error)
      : inner_(std::move(inner)), left_(nth), error_(error) {}
  Location Locate(std::string_view name) override;
  uint64_t ContentHash() override { return inner_->ContentHash(); }
  bool has_failed() const { return left_ == 0; }
  const std::string& failed_name() const { return failed_name_; }

 private:
  const std::shared_ptr<MemoryStick> inner_;
  int left_;
  std::string failed_name_;
  const int error_;
};

// Returns whether `name`, one part of a path, is an 8.3 name (at most 8 characters, a dot and at
// most 3 characters) of characters that FAT allows.
bool IsShortName(std::string_view name);

}  // namespace openr_host
