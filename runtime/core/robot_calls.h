// OPENR_ROBOT_CALLS: the table of the OPENR:: functions that a robot answers, such as
// OPENR::GetVolumeSwitch().
//
// The following classes and lists get all or most of their functions from this table:
//   RobotServices        the interface, and the results of a robot without devices
//   VirtualRobot         the declarations of the functions of the simulated robot
//   ForwardingServices   passes calls to other RobotServices in the same process
//   RemoteServices       passes calls of a worker process to the master
//   WorkerCallList       the numbers of the functions in samples to the master
// docs/architecture.md, "How to add a function that the robot answers", says what a new row needs.
#pragma once

#include <OPENR/OPENRAPI.h>

// Calls CALL(name, parameters, arguments, without_devices) for each function.  `arguments` are the
// names of the parameters, with which generated functions pass a call on.  `without_devices` is the
// result of a robot without devices, an expression that may use the parameters.
//
// Calls CALL_WITH_MEMORY instead of CALL for a function that gets memory of its caller as a `void*`
// or as the id of a region.  call_codec.h cannot send this memory.  So RemoteServices and
// CheckedCalls, which send and receive the bytes of the memory, define the function by hand.
//
// The parameter `gains` has the six numbers of a joint's PID control: P, I, D gain, then P, I, D
// shift.  A gain acts like gain x 2^(shift - 16) (robot.md 8).
//
// The order of the rows is the order of the functions' numbers in samples.  So a new row goes to
// the end, and any other change of the order needs a new openr_wire::VERSION.
// clang-format off
#define OPENR_ROBOT_CALLS(CALL, CALL_WITH_MEMORY)                                                  \
  CALL_WITH_MEMORY(SetCdtVectorData, (MemoryRegionID id), (id), oNOT_SUPPORTED)                    \
                                                                                                   \
  CALL(OpenPrimitive, (const char* locator, OPrimitiveID* id), (locator, id),                      \
       (*id = oprimitiveID_UNDEF, oNOT_FOUND))                                                     \
  CALL(ClosePrimitive, (OPrimitiveID id), (id), oINVALID_PRIMITIVE_ID)                             \
  CALL_WITH_MEMORY(ControlPrimitive,                                                               \
       (OPrimitiveID id, OPrimitiveRequest request, void* param, size_t param_size, void* result,  \
        size_t result_size),                                                                       \
       (id, request, param, param_size, result, result_size), oINVALID_PRIMITIVE_ID)               \
                                                                                                   \
  CALL(EnableJointGain, (OPrimitiveID id), (id), oINVALID_PRIMITIVE_ID)                            \
  CALL(DisableJointGain, (OPrimitiveID id), (id), oINVALID_PRIMITIVE_ID)                           \
  CALL(SetJointGain, (OPrimitiveID id, const word gains[6]), (id, gains), oINVALID_PRIMITIVE_ID)   \
  CALL(GetJointGain, (OPrimitiveID id, word gains[6]), (id, gains), oINVALID_PRIMITIVE_ID)         \
  CALL(RegisterDefaultJointGain, (OPrimitiveID id, const word gains[6]), (id, gains),              \
       oINVALID_PRIMITIVE_ID)                                                                      \
  CALL(SetDefaultJointGain, (OPrimitiveID id), (id), oINVALID_PRIMITIVE_ID)                        \
  CALL(GetDefaultJointGain, (OPrimitiveID id, word gains[6]), (id, gains), oFAIL)                  \
  CALL(GetJointValue, (OPrimitiveID id, OJointValue* value), (id, value), oINVALID_PRIMITIVE_ID)   \
  CALL(GetSensorValue, (OPrimitiveID id, OSensorValue* value), (id, value),                        \
       oINVALID_PRIMITIVE_ID)                                                                      \
                                                                                                   \
  CALL(NewSyncKey, (OVRSyncKey* key), (key), (*key = ovrsynckeyUNDEF, oNO_SYNC_KEY))               \
  CALL(CancelSyncKey, (OVRSyncKey key), (key), oINVALID_SYNC_KEY)                                  \
  CALL(DivideSyncKey, (OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2), (key, key1, key2),     \
       (*key1 = *key2 = ovrsynckeyUNDEF, oFAIL))                                                   \
                                                                                                   \
  CALL(SetMotorPower, (OPower power), (power), oNOT_SUPPORTED)                                     \
  CALL(GetBootCondition, (OBootCondition* condition), (condition), oNOT_SUPPORTED)                 \
  CALL(Shutdown, (const OBootCondition& condition), (condition), oNOT_SUPPORTED)                   \
  CALL(GetPowerStatus, (OPowerStatus* status), (status), oNOT_SUPPORTED)                           \
  CALL(ObservePowerStatus, (const OPowerStatus& notify, const OServiceEntry& entry),               \
       (notify, entry), oNOT_SUPPORTED)                                                            \
  CALL(UnobservePowerStatus, (const OServiceEntry& entry), (entry), oNOT_SUPPORTED)                \
                                                                                                   \
  CALL(SetTime, (const OTime& time), (time), oNOT_SUPPORTED)                                       \
  CALL(GetTime, (OTime* time), (time), oNOT_SUPPORTED)                                             \
  CALL(SetTimeDifference, (sbyte hours), (hours), oNOT_SUPPORTED)                                  \
  CALL(GetTimeDifference, (sbyte* hours), (hours), oNOT_SUPPORTED)                                 \
  CALL(SetVolumeSwitch, (OVolumeSwitch volume), (volume), oNOT_SUPPORTED)                          \
  CALL(GetVolumeSwitch, (OVolumeSwitch* volume), (volume), oNOT_SUPPORTED)
// clang-format on
