// The Memory Stick: what objects see under /MS.
//
// Names are absolute, begin with /MS/, use '/', and match in any case, as on the
// robot's FAT file system.  No name leaves the stick.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace openr_host {

class Hasher;

class MemoryStick {
 public:
  virtual ~MemoryStick() = default;

  // Where the file or folder lies on the host.  `error` is 0 or an errno: ENOENT
  // (also for names outside of /MS), EINVAL (a zero in it), EACCES, EIO.
  // For a file that does not exist but whose folder does, `path` is where to create
  // it, `exists` is false and error is 0.
  struct Location {
    std::string path;
    bool exists = false;
    int error = 0;
  };
  virtual Location Locate(std::string_view name) = 0;

  // For the boot and for design data; nullopt when the file cannot be read: WhyUnread() tells why.
  std::optional<std::string> ReadFile(std::string_view name);
  // An errno: ENOENT when there is no such file, EACCES when it may not be read.
  int WhyUnread(std::string_view name);

  // Names (below /MS) and contents of all files but images, which differ from build to
  // build (what they do is in the trace), and the record of a crash.  0 without files.
  virtual uint64_t ContentHash() = 0;

  // Called when an object is about to make, write, rename or remove `name`: from then on its
  // content is part of the state.
  void NoteWritten(std::string_view name);

  // `listener` hears of each file or folder before an object changes it for the first time.
  using ChangeListener = std::function<void(const Location&)>;
  void OnFirstChange(ChangeListener listener) { listener_ = std::move(listener); }

  bool writable() const { return writable_; }
  void set_writable(bool writable) { writable_ = writable; }

  // Names and contents of the files objects have written.
  void HashState(Hasher* hasher);

 protected:
  // Adds the size and the bytes of a file, a piece at a time, since it may be larger than the
  // memory of the host; `otherwise` when it cannot be read.
  void HashFile(std::string_view name, std::string_view otherwise, Hasher* hasher);

 private:
  bool writable_ = true;
  std::set<std::string> written_;
  ChangeListener listener_;
  std::set<std::string> changed_;  // paths `listener_` has heard of
};

// A folder of the host that holds OPEN-R/.
class FolderStick : public MemoryStick {
 public:
  explicit FolderStick(std::string root) : root_(std::move(root)) {}
  Location Locate(std::string_view name) override;
  uint64_t ContentHash() override;
  const std::string& root() const { return root_; }

 private:
  std::string root_;
};

// For tests: another stick whose n-th Locate() from now fails with `error`.
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

// Whether `name` (one part of a path) fits 8 + 3 characters of those FAT allows.
bool IsShortName(std::string_view name);

}  // namespace openr_host
