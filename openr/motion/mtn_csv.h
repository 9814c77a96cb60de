// Motions as comma-separated values: the output of `openr mtn dump` and the input of `openr mtn
// from-csv`.
//
// The first line has the names of the columns: key_frame, time_ms, roll_deg, pitch_deg, yaw_deg,
// then the locators of the joints.  Each further line is a key frame.  Angles are in degrees with
// five decimals, so that the angles of a motion file are kept to the micro-radian.  Ears have two
// positions, so their values are 0 or 1. The text does not have the names that are in the motion
// file (motion, creator, design label).
#pragma once

#include <string>

#include "MtnFile.h"
#include "openr/motion/mtn_writer.h"

namespace openr_host {

// Returns whether `locator` names an ear.  An ear has two positions instead of an angle: 0 is one
// position, any other value is the other position.
bool HasTwoPositions(const std::string& locator);

std::string CsvOf(const MtnFile& motion);

// Reads a motion from text in the format that CsvOf() writes.  Throws std::runtime_error with the
// mistake, such as "line 4, column time_ms: ...", if the format is wrong, or if a value does not
// fit into a motion file.
MotionFile ParseMotionCsv(const std::string& text);

}  // namespace openr_host
