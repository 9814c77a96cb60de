// The messages that OPENR:: functions send to the system objects of the robot (binary.md, 4).  All
// words have 32 bits, little-endian; the first word is a type.
//
// Only messages with a known layout are supported: the messages of OVirtualRobot about primitives,
// gains, joint and sensor values and sync keys, the message of ODesignedRobot for the robot design,
// and two messages of OPowerManager.  The layouts of these two messages are inferred.  The message
// of SetMotorPower has only two words, so the argument must be the word after the type.  The answer
// to GetPowerStatus is as large as an OPowerStatusMessage, so we assume the same layout.  Other
// messages of OPowerManager are not supported, because only their sizes are known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace openr_host {

class RobotServices;

inline constexpr char kVirtualRobot[] = "OVirtualRobot";
inline constexpr char kPowerManager[] = "OPowerManager";
inline constexpr char kDesignedRobot[] = "ODesignedRobot";

enum VirtualRobotSelector : uint32_t {
  kOpenSelector = 4,
  kCloseSelector = 5,
  kControlSelector = 9
};
enum PowerManagerSelector : uint32_t { kMotorPowerSelector = 7, kPowerStatusSelector = 15 };
enum DesignedRobotSelector : uint32_t { kRobotDesignSelector = 13 };

// The numbers of the requests to the entry kControlSelector of the system object OVirtualRobot
// (binary.md, 4.1).
enum class ControlRequest : uint32_t {
  kNewSyncKey = 4,
  kCancelSyncKey = 5,
  kEnableGain = 8,
  kDisableGain = 9,
  kSetGain = 11,
  kRegisterGain = 12,
  kSetDefaultGain = 13,
  kJointValue = 14,
  kSensorValue = 15,
  kGetGain = 20,
  kGetDefaultGain = 21,
};

inline constexpr size_t kLocatorBytes = 128;
inline constexpr size_t kOpenReplyBytes = 12;   // size of a reply with type, status, primitive ID
inline constexpr size_t kStatusReplyBytes = 8;  // size of a reply with type and status
inline constexpr size_t kControlBytes = 224;    // size of a control request and of its reply
// Offset of the parameter in a control request, and of the result in its reply.
inline constexpr size_t kControlParamAt = 32;
inline constexpr size_t kPowerStatusBytes = 24;  // size of a message with type and OPowerStatus
inline constexpr size_t kRobotDesignBytes = 40;  // size of a message with type, name[32] and status
inline constexpr uint32_t kStatusType = 2;       // first word of a reply that has only a status
inline constexpr uint32_t kOpenType = 1024;
// The type (first word) of the reply to a request to open a primitive.  A request to close a
// primitive has the same type.
inline constexpr uint32_t kOpenReplyType = 1025;
inline constexpr uint32_t kControlType = 1027;
// The type of a message to OPowerManager is the sum of this number and the selector.  The number is
// our choice, because receivers ignore it.
inline constexpr uint32_t kPowerType = 1024;

// Returns the 32-bit word at `offset` of `bytes`, or 0 if `bytes` ends before the end of the word.
uint32_t WordIn(const std::string& bytes, size_t offset);

// Returns the message to the entry kControlSelector of OVirtualRobot that asks for `request` with
// the parameter `param`.  REQUIRES: `param` fits into kControlBytes - kControlParamAt bytes.
std::string ControlMessage(ControlRequest request, const std::string& param);

// Lets `services` execute a message to an entry of one of the robot's system objects, and returns
// the answer.  If the object or entry is not supported, or the message is too short, returns "" and
// sets `*why` to the reason.
std::string AnswerSystemMessage(RobotServices* services, const std::string& design,
                                const std::string& name, uint32_t selector,
                                const std::string& message, std::string* why);

}  // namespace openr_host
