#include "openr/remote/log_reader.h"

#include "RemoteLog.h"
#include "openr/remote/connection.h"

namespace openr::remote {
namespace {

// The payload of the request LOG, which asks for records of a motion's log.
struct RecordNumber {
  uint32_t number;
  void Write(RcWriter* out) const { out->U32(number); }
};

// The payload of the answer to LOG: some records of a motion's log.
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

void LogReader::SkipOld() {
  const Answer answer = connection_->Request(rcLOG, Connection::BytesOf(RecordNumber{RC_LOG_END}));
  next_ = connection_->Read<LogPart>(answer).head.count;
}

int LogReader::ReadNewRecords() {
  for (;;) {
    const Answer answer = connection_->Request(rcLOG, Connection::BytesOf(RecordNumber{next_}));
    const auto part = connection_->Read<LogPart>(answer);
    frame_ = answer.frame;
    lost_ += part.head.first - next_;
    next_ = part.head.first + part.head.here;
    count_ += part.head.here;
    records_ += part.records;
    if (next_ == part.head.count) return part.head.state;
    // Throws an error if the robot sends no record although the log has more records, because
    // without this check the loop would never end.
    if (part.head.here == 0)
      throw Error(ErrorCode::kProtocol,
                  connection_->address().Text() + ": the robot sends no records of its log");
  }
}

std::string LogReader::File() const { return RC_LOG_HEADER + records_; }

}  // namespace openr::remote
