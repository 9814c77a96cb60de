#include "openr/inspect/answer_difference.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <cstring>
#include <sstream>

#include "cli/counted.h"
#include "openr/decode/decode_message.h"
#include "openr/inspect/trace_text.h"
#include "runtime/base/assert.h"

namespace openr_host {
namespace {

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

AnswerDifference CompareAnswer(const RobotModel& model, const std::string& entry,
                               const std::string& now, const std::string& then) {
  ASSERT(now.size() == then.size());
  AnswerDifference difference;
  for (size_t i = 0; i < now.size(); ++i) {
    if (now[i] == then[i]) continue;
    if (difference.count++ == 0) difference.first = i;
  }
  const std::vector<std::string> lines = LinesOf(DecodeContent(model, entry, now));
  const std::vector<std::string> others = LinesOf(DecodeContent(model, entry, then));
  if (lines.size() != others.size()) return difference;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == others[i]) continue;
    difference.now.push_back(lines[i]);
    difference.then.push_back(others[i]);
  }
  return difference;
}

void PutContent(const Message& message, const std::string& bytes) {
  if (message.kind == PayloadKind::kBytes) {
    ASSERT(bytes.size() == message.size);
    std::memcpy(const_cast<unsigned char*>(message.payload), bytes.data(), bytes.size());
    return;
  }
  ASSERT(message.kind == PayloadKind::kNotify);
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  size_t at = 0;
  for (int i = 0; i < notify.numOfData; ++i) {
    const size_t size = notify.data[i].size;
    ASSERT(bytes.size() - at >= size);
    std::memcpy(notify.data[i].srcRCR->Base(), bytes.data() + at, size);
    at += size;
  }
}

std::string DescribeAnswer(const AnswerDifference& difference) {
  const TraceRecord& record = difference.record;
  std::string text = fmt::format(
      "message {} (t={:.6f} s, to {}, selector {}, \"{}\"): {} of {} differ, from byte {} on\n",
      record.number, Seconds(record.time_us), difference.receiver, record.selector,
      difference.entry, difference.count, Counted(record.size, "byte"), difference.first);
  for (size_t i = 0; i < difference.now.size(); ++i)
    text +=
        fmt::format("    now:      {}\n    recorded: {}\n", difference.now[i], difference.then[i]);
  return text;
}

}  // namespace openr_host
