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
  if (end_size_ > 0) lseek(descriptor_, static_cast<off_t>(size_), SEEK_SET);
  // One write for both, because the process may be killed between two.
  error_ = end.empty() ? WriteAll(descriptor_, bytes)
                       : WriteAll(descriptor_, std::string(bytes).append(end));
  if (error_ == 0) {
    const bool is_shorter = bytes.size() + end.size() < end_size_;
    size_ += bytes.size();
    end_size_ = end.size();
    if (!is_shorter) return;
  }
  // Cuts the rest of a longer end, or the bytes that a full disk had room for.  A device or pipe
  // cannot be cut.
  const size_t size = error_ == 0 ? size_ + end_size_ : size_;
  [[maybe_unused]] const int result = ftruncate(descriptor_, static_cast<off_t>(size));
}

std::string GrowingFile::Problem() const {
  if (error_ == 0) return "";
  return WhyNotWritten(file_, error_);
}

}  // namespace openr_host
