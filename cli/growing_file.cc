#include "cli/growing_file.h"

#include <unistd.h>

#include <stdexcept>

#include "cli/output_file.h"

namespace openr_host {

GrowingFile::GrowingFile(const std::string& file) : file_(file) {
  std::string problem;
  descriptor_ = OpenGrowingFile(file, &problem);
  if (descriptor_ < 0) throw std::runtime_error(problem);
  can_go_back_ = lseek(descriptor_, 0, SEEK_CUR) >= 0;
}

GrowingFile::~GrowingFile() { close(descriptor_); }

void GrowingFile::Append(std::string_view bytes, std::string_view end) {
  if (error_ != 0) return;
  if (!can_go_back_) end = "";
  const auto go_back = [this] { lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET); };
  if (!end_.empty()) go_back();
  // Writes `bytes` and `end` in one call, because the process may be killed between two calls.
  error_ = end.empty() ? WriteAll(descriptor_, bytes)
                       : WriteAll(descriptor_, std::string(bytes).append(end));
  if (error_ == 0) {
    const bool is_shorter = bytes.size() + end.size() < end_.size();
    size_ += bytes.size();
    end_ = end;
    if (!is_shorter) return;
  } else if (!end_.empty()) {
    // Writes the old `end_` again, the text that completes the file, because the part of `bytes`
    // that fitted on the disk has overwritten it.
    go_back();
    WriteAll(descriptor_, end_);
  }
  // Cuts off what follows the appended bytes and `end_` in the file.  A device or a pipe cannot be
  // cut, so a failure is ignored.
  [[maybe_unused]] const int result =
      ftruncate(descriptor_, static_cast<off_t>(size_ + end_.size()));
}

std::string GrowingFile::Problem() const {
  if (error_ == 0) return "";
  return WhyNotWritten(file_, error_);
}

}  // namespace openr_host
