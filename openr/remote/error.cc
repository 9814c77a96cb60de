#include "openr/remote/error.h"

#include "RemoteProtocol.h"

namespace openr::remote {
namespace {

// Returns what the user can do after the robot has refused a request; "" if the robot's text gives
// the advice already.
std::string AdviceFor(int status) {
  switch (status) {
    case rcerrorVERSION:
    case rcerrorUNKNOWN_COMMAND:
    case rcerrorNOT_IMPLEMENTED:
      return "the robot's software is older than this command; put a newer RCServer on its stick";
    case rcerrorBAD_PACKET:
    case rcerrorMALFORMED:
      return "the program that made the request has an error; docs/remote-control.md has the form";
    case rcerrorNOT_WRITTEN:
      return "delete motions that are not needed, or remove the stick's write protection";
    case rcerrorNO_UPLOAD:
      return "begin the upload again";
    case rcerrorTOO_LONG:
      return "ask again, alone";
    case rcerrorNO_PICTURE:
      return "ask for a new picture";
    default:
      return "";
  }
}

std::string Joined(const std::string& text, const std::string& advice) {
  return advice.empty() ? text : text + "; " + advice;
}

}  // namespace

Error::Error(ErrorCode code, const std::string& text, const std::string& advice)
    : std::runtime_error(Joined(text, advice)), code_(code), text_(text), advice_(advice) {}

Error::Error(int status, uint32_t frame, const std::string& text)
    : std::runtime_error(Joined(text, AdviceFor(status))),
      code_(ErrorCode::kRefused),
      text_(text),
      advice_(AdviceFor(status)),
      status_(status),
      frame_(frame) {}

bool Error::IsConnectionUsable() const {
  switch (code_) {
    case ErrorCode::kRefused:
      return status_ != rcerrorBAD_PACKET;
    case ErrorCode::kNoDevice:
    case ErrorCode::kFileChanged:
      return true;
    default:
      return false;
  }
}

}  // namespace openr::remote
