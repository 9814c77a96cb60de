// The units in which charts show quantities.
#pragma once

#include <string>

namespace openr_host {

struct QuantityUnit {
  const char* text;  // name of the unit, such as "m/s^2"; "": a plain number
  double factor;     // factor that converts a value of a log to this unit
  // Smallest span of an axis that shows values in this unit; it keeps small noise from filling a
  // panel of the chart.
  double span_min;
};

// Returns the unit of the quantity `name`, such as "pitch_deg" or "robots[1].sensor.distance".  The
// unit depends on the name alone, and not on values.  A sensor has OPEN-R's unit, as in logs of
// --log-data; the kind of the sensor is looked up in the models of all robots.  The name of any
// other quantity ends with its unit, but the name of a joint angle does not: for joint angles the
// caller must use degrees and not call this function.  Throws std::runtime_error when a model
// cannot be read.
QuantityUnit UnitOfQuantity(const std::string& name);

}  // namespace openr_host
