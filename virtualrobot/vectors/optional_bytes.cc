#include "virtualrobot/vectors/optional_bytes.h"

#include <fmt/format.h>

#include <cstring>

#include "runtime/base/hasher.h"

namespace openr_host {

void OptionalBytes::CopyFrom(const ODataVectorInfo& sent, std::vector<std::string>* problems) {
  if (sent.optSize == 0) return;
  if (sent.optOffset > odataOPTIONAL_MAX || sent.optSize > odataOPTIONAL_MAX - sent.optOffset) {
    problems->push_back(
        fmt::format("vector: {} optional bytes at {} do not fit into {}; they are not passed on",
                    sent.optSize, sent.optOffset, odataOPTIONAL_MAX));
    return;
  }
  offset_ = sent.optOffset;
  size_ = sent.optSize;
  std::memcpy(&bytes_[offset_], &sent.optional[offset_], size_);
}

void OptionalBytes::Put(ODataVectorInfo* header) const {
  header->optOffset = offset_;
  header->optSize = size_;
  std::memcpy(header->optional, bytes_.data(), bytes_.size());
}

void OptionalBytes::HashState(Hasher* hasher) const {
  hasher->Add(offset_);
  hasher->Add(size_);
  hasher->AddBytes(bytes_.data(), bytes_.size());
}

}  // namespace openr_host
