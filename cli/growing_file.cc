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
  if (error_ == 0) error_ = WriteAll(descriptor_, bytes);
}

std::string GrowingFile::Problem() const {
  if (error_ == 0) return "";
  return WhyNotWritten(file_, error_);
}

}  // namespace openr_host
