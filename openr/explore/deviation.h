// A deviation is a place where a run of an exploration leaves the canonical order of messages,
// which is the order of a run without exploration.  A random schedule writes its deviations down,
// and a scripted schedule repeats them.
//
// A place is named by facts that stay the same when other deviations are removed: an instant, a
// receiver, or the number of a message from one object to another.  Therefore a search can remove
// single deviations from a list, and a person can read the list.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

struct Deviation {
  enum class Kind : uint8_t {
    kStart,  // at the nth choice of the object that starts next, `object` is chosen
    // At the nth tie at time_us, when several objects have a message due, `object` goes first.
    kTie,
    // The nth message from `sender` to entry `selector` of `object` comes `us` microseconds later.
    kDelay,
    // The nth call of entry `selector` of `object` takes `us` microseconds longer (shorter if
    // negative).
    kCost,
    kFrame,  // the frame counter of robot number `nth` begins with the number in the field `us`
    // The nth fault of the run comes at time_us to the robot whose number is in the field
    // `selector`.  The field `us` has the number of the fault, which FaultLine() converts to an
    // input.
    kFault,
  };
  Kind kind = Kind::kTie;
  // Virtual time of the deviation.  For kTie, this time and `nth` say which tie of the run is
  // meant.  For kFault, the fault comes at this time.  For kDelay and kCost, the time is only for
  // people.  For kStart and kFrame, it is not used.
  int64_t time_us = 0;
  uint64_t nth = 0;  // the n of "the nth call" in the comments of Kind, counted from 0
  ObjectId object = kNoObject;
  ObjectId sender = kNoObject;
  uint32_t selector = 0;
  int64_t us = 0;

  bool operator==(const Deviation&) const = default;
};

// Converts a deviation to one line of a schedule file.  The fields are those of Deviation, except
// that an object is given by its name and the number of its robot.  "entry" is the name of the
// handler `selector`, and "line" the input of a fault; both are for people.
//   {"kind":"tie","time_us":8000,"nth":0,"robot":0,"object":"RCServer"}
//   {"kind":"fault","time_us":8000,"nth":0,"robot":0,"line":"break chin dead for 300ms","us":57}
//   {"kind":"delay","time_us":..,"nth":17,"robot":0,"object":"B","sender":"A","selector":7,
//    "entry":"B.In.Number.O (Notify)","us":4000}
nlohmann::ordered_json DeviationToJson(const Deviation& deviation, const System& system);

// Converts one line of a schedule file to a deviation.  Throws std::runtime_error if a field is
// missing or an object does not exist.  Does not read the fields "entry" and "line", because they
// are only for people.
Deviation DeviationFromJson(const nlohmann::ordered_json& json, const System& system);

}  // namespace openr_host
