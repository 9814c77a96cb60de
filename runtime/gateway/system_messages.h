// Messages to the robot's system objects: what the OPENR:: functions become when they leave the
// object (binary.md, 4).  Words of 32 bits, little-endian; the first is a type.
//
// Known by their layout, and so carried: the primitives, gains, joint and sensor values and sync
// keys of OVirtualRobot, the design of ODesignedRobot, and of OPowerManager SetMotorPower (its type
// word and the place of its argument are inferred from its size) and GetPowerStatus (inferred from
// OPowerStatusMessage, which has its size).  Of OPowerManager's other messages only the sizes are
// known: they are not carried.
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

// Requests of kControlSelector (binary.md, 4.1).
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
inline constexpr size_t kOpenReplyBytes = 12;    // type, status, primitive
inline constexpr size_t kStatusReplyBytes = 8;   // type, status
inline constexpr size_t kControlBytes = 224;     // request and reply
inline constexpr size_t kControlParamAt = 32;    // parameter, and result
inline constexpr size_t kPowerStatusBytes = 24;  // type, OPowerStatus
inline constexpr size_t kRobotDesignBytes = 40;  // type, name[32], status
inline constexpr uint32_t kStatusType = 2;       // of a reply that is only a status
inline constexpr uint32_t kOpenType = 1024;
inline constexpr uint32_t kOpenReplyType = 1025;  // and of a close request
inline constexpr uint32_t kControlType = 1027;
inline constexpr uint32_t kPowerType = 1024;  // plus the selector: ours, nobody reads it here

// The word at `offset`; 0 beyond the end.
uint32_t WordIn(const std::string& bytes, size_t offset);

// A request of kControlSelector.  `param`: its parameter.
std::string ControlMessage(ControlRequest request, const std::string& param);

// The answer of the object `name` to a message.  "" when there is no such object or entry here, or
// when the message is too short; `*why` says which.
std::string AnswerSystemMessage(RobotServices* services, const std::string& design,
                                const std::string& name, uint32_t selector,
                                const std::string& message, std::string* why);

}  // namespace openr_host
