// Says what an EMON.LOG of a robot means: the cause, the object, the function and the line.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/emon/emon_log.h"
#include "openr/emon/robot_code.h"

namespace openr_host {

// The place of an instruction in the image of an object.
struct CodePlace {
  uint32_t address = 0;  // address in the memory of the robot
  uint32_t in_file = 0;  // address in the image file
  CodeLookup code;
};

// The explanation of a crash: its crash record, and what the image of the object says about the
// crash.
struct CrashExplanation {
  EmonLog log;
  std::string meaning;  // meaning of the exception code; "" if the record has no code
  // The instruction that failed; nullopt if it is not known or not in the image.
  std::optional<CodePlace> place;
  // Calls that may have led to the instruction that failed, the last call first.  They are found by
  // their return addresses: the value of register ra, and each word on the stack that could be a
  // return address.  Some of these calls may be left from functions that had already returned.
  std::vector<CodePlace> calls;
  bool has_more_calls = false;  // true: more calls were found, and left out of `calls`
  // Reason why the explanation lacks the instruction that failed, its function or its line; "" if
  // it lacks nothing.
  std::string problem;
};

// Explains the crash that the crash record `log` describes.  `code` is the image of the object that
// crashed; null if there is no image.
CrashExplanation ExplainCrash(const EmonLog& log, RobotCode* code);

std::string ExplanationText(const CrashExplanation& explanation);
nlohmann::ordered_json ExplanationJson(const CrashExplanation& explanation);

}  // namespace openr_host
