// Checks files before they are sent to a robot, so that nothing is sent that the robot would
// refuse.
#pragma once

#include <string>

#include "RemoteProtocol.h"

namespace openr_host {

// Throws std::runtime_error "FILE: reason" when `bytes` are no motion for the robot that `info` is
// about.  `file` is the name of the motion for the message.
void CheckMotion(const std::string& file, const std::string& bytes, const RcInfo& info);

// Returns the bytes to send for an image that has these bytes, which may be packed with gzip.
// Throws std::runtime_error "FILE: reason" when the image is not for the processor of the robot, or
// is too large.
std::string ImageToSend(const std::string& file, std::string bytes, const RcInfo& info);

}  // namespace openr_host
