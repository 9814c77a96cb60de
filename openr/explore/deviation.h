// A deviation is a place where a run left the canonical order.  Random schedules write deviations
// down, and scripted schedules play them again.
//
// The place is named by facts that stay the same when other deviations are removed: an instant, a
// receiver, the n-th message from one object to another.  Therefore a list of deviations can be
// shortened, and a person can read it.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

struct Deviation {
  enum class Kind : uint8_t {
    kStart,  // `object` makes the nth DoStart of which the order is open
    kTie,    // `object` goes first the nth time that several have a message due at time_us
    kDelay,  // nth message from `sender` to entry `selector` of `object` comes us later
    kCost,   // nth call of entry `selector` of `object` takes us more (or less, if negative)
    kFrame,  // robot number nth counts its frames from us on
  };
  Kind kind = Kind::kTie;
  int64_t time_us = 0;  // for kTie; in kDelay and kCost only for people to read
  uint64_t nth = 0;     // from 0
  ObjectId object = kNoObject;
  ObjectId sender = kNoObject;
  uint32_t selector = 0;
  int64_t us = 0;

  bool operator==(const Deviation&) const = default;
};

// One line of a schedule file, with names instead of ids:
//   {"kind":"tie","time_us":8000,"nth":0,"robot":0,"object":"RCServer"}
//   {"kind":"delay","time_us":..,"nth":17,"robot":0,"object":"B","sender":"A","selector":7,
//    "entry":"B.In.Number.O (Notify)","us":4000}
nlohmann::ordered_json DeviationToJson(const Deviation& deviation, const System& system);

// Reads a line of a schedule file.  Throws std::runtime_error if a field is missing or an object
// does not exist.  The field "entry" is for people and is not read.
Deviation DeviationFromJson(const nlohmann::ordered_json& json, const System& system);

}  // namespace openr_host
