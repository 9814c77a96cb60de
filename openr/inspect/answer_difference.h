// Answers: the messages that one object sends in a replay, compared with the recorded messages.
//
// The other objects get the recorded bytes of these messages, so that they do what they did in the
// recorded run.  Otherwise one different answer would change all messages after this answer.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/trace.h"

namespace openr_host {

struct RobotModel;

// A message that was sent by the object that openr replay --only names, and that has other bytes
// than the recorded message.
struct AnswerDifference {
  TraceRecord record{};         // describes the message in the replay
  std::string receiver, entry;  // names of the receiver and of its entry (handler)
  size_t first = 0;             // index of the first byte that differs
  size_t count = 0;             // number of bytes that differ
  // Values that differ, as text: `now` in the replay, `then` in the recording.  Both are empty if
  // the type of the content is not known.
  std::vector<std::string> now, then;
};

// Returns the difference between `now`, the content of a message in the replay, and `then`, the
// recorded content of the same message.  Both have the same size.  `entry` is the name of the
// receiver's entry, which tells the type of the content.
AnswerDifference CompareAnswer(const RobotModel& model, const std::string& entry,
                               const std::string& now, const std::string& then);

// Replaces the content of `message` by the recorded content `bytes` of the same size, before the
// message is delivered.  REQUIRES: `message` is a notification or has plain bytes.
void PutContent(const Message& message, const std::string& bytes);

// Returns lines of text for a human reader that describe `difference`, the difference between a
// message and its recording.
std::string DescribeAnswer(const AnswerDifference& difference);

}  // namespace openr_host
