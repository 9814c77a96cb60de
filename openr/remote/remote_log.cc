#include "openr/remote/remote_log.h"

#include <stdexcept>

#include "RemoteLog.h"
#include "openr/remote/remote_client.h"

namespace openr_host {
namespace {

// The payload of LOG.
struct RecordNumber {
  uint32_t number;
  void Write(RcWriter* out) const { out->U32(number); }
};

// The payload of an answer to LOG.
struct LogPart {
  RcLogHead head;
  std::string records;
  bool Read(RcReader* in) {
    head.Read(in);
    records.assign(reinterpret_cast<const char*>(in->Rest()), static_cast<size_t>(in->RestSize()));
    return !in->HasFailed() && in->RestSize() == head.here * head.size;
  }
};

}  // namespace

void RemoteLog::SkipOld() {
  client_->UseVersion(RC_VERSION_FILES);
  const RemoteAnswer answer = client_->RequestWith(rcLOG, RecordNumber{RC_LOG_END});
  next_ = client_->Read<LogPart>(answer).head.count;
}

int RemoteLog::Take() {
  client_->UseVersion(RC_VERSION_FILES);
  for (;;) {
    const RemoteAnswer answer = client_->RequestWith(rcLOG, RecordNumber{next_});
    const auto part = client_->Read<LogPart>(answer);
    frame_ = answer.frame;
    lost_ += part.head.first - next_;
    next_ = part.head.first + part.head.here;
    count_ += part.head.here;
    records_ += part.records;
    if (next_ == part.head.count) return part.head.state;
  }
}

std::string RemoteLog::File() const { return RC_LOG_HEADER + records_; }

}  // namespace openr_host
