// Checks files before they are sent to a robot, because the robot would refuse a wrong file only
// after the upload.
#pragma once

#include <string>

#include "RemoteProtocol.h"

namespace openr_host {

// Throws std::runtime_error "FILE: reason" if `bytes` are no motion for the robot that `info`
// describes.  `file` is the name of the motion, for the message.
void CheckMotion(const std::string& file, const std::string& bytes, const RcInfo& info);

// Returns the bytes to send for the image `bytes`, which may be packed with gzip.  Throws
// std::runtime_error "FILE: reason" if the image is too large or not for the processor of the
// robot.
std::string ImageToSend(const std::string& file, std::string bytes, const RcInfo& info);

}  // namespace openr_host
