// Answers: the messages that one object sends in a replay, compared with the recorded ones.
//
// The other objects get the recorded bytes, so they do what they did then, and one different answer
// does not change all that follows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/trace.h"

namespace openr_host {

struct RobotModel;

// A message of the object with other bytes than the recorded one.
struct AnswerDifference {
  TraceRecord record{};                // of the message now
  std::string receiver, entry;         // the names of its receiver and of the receiver's entry
  size_t first = 0;                    // the first byte that differs
  size_t count = 0;                    // how many bytes differ
  std::vector<std::string> now, then;  // values that differ, as text; empty: of an unknown type
};

// Returns the difference between the content of a message now and the recorded content, of the same
// size.  `entry` names the type of the content.
AnswerDifference CompareAnswer(const RobotModel& model, const std::string& entry,
                               const std::string& now, const std::string& then);

// Gives `message`, which is about to be delivered, the recorded content `bytes`, of the same size.
// REQUIRES: `message` is a notification or has plain bytes.
void PutContent(const Message& message, const std::string& bytes);

// Returns lines about the difference for people.
std::string DescribeAnswer(const AnswerDifference& difference);

}  // namespace openr_host
