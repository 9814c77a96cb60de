// GrowingFile: a file that grows while a run goes on, such as a log of data.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace openr_host {

class GrowingFile {
 public:
  // Creates `file`, or empties it.  Throws std::runtime_error when it cannot be created, or when
  // another process is writing to it.
  explicit GrowingFile(const std::string& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  // Appends `bytes`.  If that fails, takes back what was written of them and writes nothing more,
  // so that the file ends with a whole record.
  void Append(std::string_view bytes);

  // Returns "FILE: cannot be written: why" if a write has failed, else "".
  std::string Problem() const;

 private:
  const std::string file_;
  int descriptor_ = -1;
  size_t size_ = 0;  // bytes of all appended records
  int error_ = 0;    // errno of the first failed write
};

}  // namespace openr_host
