// Limits: what the figures of a variant should reach.  A limit is only reported; none fails a run.
#pragma once

#include <string>

namespace openr_host {

struct Limit {
  enum class Kind {
    kRatioAtMost,    // at most `value` times the time of the floor
    kRatioAtLeast,   // at least `value` times the time of the floor
    kMoreThanFloor,  // at most `value` ns more than the floor
    kTime,           // at most `value` ns
  };
  Kind kind = Kind::kTime;
  double value = 0;
};

// The figures of a variant that limits are compared with.
struct Figures {
  double time_ns = 0;  // time of an operation
  double ratio = 0;    // the time, divided by the time of the floor
  double more_ns = 0;  // the time less the time of the floor
};

bool IsMet(const Limit& limit, const Figures& figures);

// Returns the kind of `limit` for programs, such as "ratio_at_most".
const char* NameOf(Limit::Kind kind);
// Returns `limit` for people, such as "<= 1.10x" or "<= +3.0 us".
std::string TextOf(const Limit& limit);
// Returns a time for people, with a unit that suits it, such as "45.2 ns" or "10.4 ms".
std::string TextOfTime(double ns);

}  // namespace openr_host
