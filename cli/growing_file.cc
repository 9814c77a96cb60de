#include "cli/growing_file.h"

#include <unistd.h>

#include <stdexcept>

#include "cli/output_file.h"

namespace openr_host {

GrowingFile::GrowingFile(const std::string& file) : file_(file) {
  std::string problem;
  descriptor_ = OpenGrowingFile(file, &problem);
  if (descriptor_ < 0) throw std::runtime_error(problem);
}

GrowingFile::~GrowingFile() { close(descriptor_); }

void GrowingFile::Append(std::string_view bytes) {
  if (error_ != 0) return;
  error_ = WriteAll(descriptor_, bytes);
  if (error_ == 0) {
    size_ += bytes.size();
    return;
  }
  // Takes back the bytes that a full disk had room for.  A device or pipe cannot be cut.
  [[maybe_unused]] const int result = ftruncate(descriptor_, static_cast<off_t>(size_));
}

std::string GrowingFile::Problem() const {
  if (error_ == 0) return "";
  return WhyNotWritten(file_, error_);
}

}  // namespace openr_host
