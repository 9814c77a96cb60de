// Motions as comma-separated values: what `openr mtn dump` prints and `openr mtn from-csv` reads.
//
// The first line has the names of the columns: key_frame, time_ms, roll_deg, pitch_deg, yaw_deg,
// then the locators of the joints.  Each further line is a key frame.  Angles are in degrees with
// five decimals, which keep every micro-radian of the file.  Ears, which have two positions, are 0
// or 1.  The names in the file (motion, creator, design label) are no part of the values.
#pragma once

#include <string>

#include "MtnFile.h"
#include "openr/motion/mtn_writer.h"

namespace openr_host {

// Returns whether `locator` names an ear.  An ear has two positions instead of an angle: the value
// 0 is one position, any other value is the other.
bool HasTwoPositions(const std::string& locator);

std::string CsvOf(const MtnFile& motion);

// Reads a motion from text in the form of CsvOf().  Throws std::runtime_error "line 4, column
// time_ms: ..." with the mistake if the form is wrong, or if no motion file can have a value.
MotionFile ParseMotionCsv(const std::string& text);

}  // namespace openr_host
