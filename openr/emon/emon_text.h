// Says what an EMON.LOG of a robot means: the cause, the object, the function and the line.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/emon/emon_log.h"
#include "openr/emon/robot_code.h"

namespace openr_host {

// A place in the code of the image.
struct CodePlace {
  uint32_t address = 0;  // on the robot
  uint32_t in_file = 0;  // address in the image file
  CodeLookup code;
};

// The story of a crash: its record, explained with the image of the object.
struct EmonStory {
  EmonLog log;
  std::string meaning;  // of the exception code; "" if the log has no code
  // The instruction that failed, if it is in the image.
  std::optional<CodePlace> place;
  // Calls that may have led there, the last one first: those that belong to the return address in
  // register ra and to each word on the stack that could be a return address.  Some may be left
  // from functions that had already returned.
  std::vector<CodePlace> calls;
  bool has_more_calls = false;  // calls were left out
  std::string problem;          // why there is no place or no name; "" if there is nothing to say
};

// `code`: the image of the object that crashed; null without one.
EmonStory TellStory(const EmonLog& log, RobotCode* code);

std::string StoryText(const EmonStory& story);
nlohmann::ordered_json StoryJson(const EmonStory& story);

}  // namespace openr_host
