// Where a run left the canonical order: what a random schedule writes down and a scripted one
// plays again.
//
// A deviation names its spot by what stays the same when others are taken out: an instant, a
// receiver, the n-th message from one object to another.  That is what makes shortening work,
// and the file readable.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

struct Deviation {
  enum class Kind : uint8_t {
    kStart,  // the nth DoStart of which the order is open is that of `object`
    kTie,    // at time_us, the nth time several objects have a message due: `object` goes first
    kDelay,  // the nth message from `sender` to entry `selector` of `object` comes us later
    kCost,   // the nth call of entry `selector` of `object` takes us more, or less
    kFrame,  // robot nth counts its frames from us on
  };
  Kind kind = Kind::kTie;
  int64_t time_us = 0;  // of kTie; of kDelay and kCost for people
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

// Throws std::runtime_error that says what is wrong: a field that is missing, an object that is not
// there.  "entry" is for people and not looked at.
Deviation DeviationFromJson(const nlohmann::ordered_json& json, const System& system);

}  // namespace openr_host
