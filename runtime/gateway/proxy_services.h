// Carries calls of the OPENR:: functions about the robot's devices from a program on a PC to the
// robot that the line !ROBOT_PROXY of HOSTGW.CFG names.
//
// A call is not sent to the robot if the layout of its message is not known.  A program that makes
// such a call gets a warning (docs/network.md has the list).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "runtime/core/message.h"
#include "runtime/gateway/forwarding_services.h"
#include "runtime/gateway/system_messages.h"

namespace openr_host {

class System;

class ProxyServices : public ForwardingServices {
 public:
  // Sends OPEN-R calls as messages to entry `selector` of the object `gateway`, which passes them
  // to the robot (proxy_client.h).  The functions that are not sent to the robot are executed by
  // `local`, the services of this run's own robot.
  ProxyServices(System* system, ObjectId gateway, uint32_t selector,
                std::unique_ptr<RobotServices> local);

  // If `*services` is a ProxyServices, replaces `*services` by the services of this run's own
  // robot.  Called when the robot boots again, because the new gateway makes a new ProxyServices.
  static void Remove(std::unique_ptr<RobotServices>* services);

  OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) override;
  OStatus ClosePrimitive(OPrimitiveID id) override;
  OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                           size_t param_size, void* result, size_t result_size) override;
  OStatus EnableJointGain(OPrimitiveID id) override;
  OStatus DisableJointGain(OPrimitiveID id) override;
  OStatus SetJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus GetJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus SetDefaultJointGain(OPrimitiveID id) override;
  OStatus GetDefaultJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus GetJointValue(OPrimitiveID id, OJointValue* value) override;
  OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) override;
  OStatus NewSyncKey(OVRSyncKey* key) override;
  OStatus CancelSyncKey(OVRSyncKey key) override;
  OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) override;
  OStatus SetCdtVectorData(MemoryRegionID id) override;
  OStatus SetMotorPower(OPower power) override;
  OStatus Shutdown(const OBootCondition& condition) override;
  OStatus GetPowerStatus(OPowerStatus* status) override;
  OStatus ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) override;
  OStatus UnobservePowerStatus(const OServiceEntry& entry) override;

  // The next five functions are called only by the runtime.  The services of this run's own robot
  // execute them, because the runtime shuts down, boots and hashes only this robot.
  std::optional<int64_t> TimeOffUs() const override { return local_->TimeOffUs(); }
  void SwitchOff() override { local_->SwitchOff(); }
  void RunFrameWhileOff() override { local_->RunFrameWhileOff(); }
  void Reseed(uint64_t seed) override { local_->Reseed(seed); }
  void HashState(Hasher* hasher) const override { local_->HashState(hasher); }

 private:
  // Sends `message` to entry `selector` of the robot's system object `object`, and waits for a
  // reply of `reply_size` bytes.  Returns false if no reply comes.  If the calling object cannot
  // wait, also returns false and adds a finding.
  bool Ask(const char* object, uint32_t selector, const std::string& message, size_t reply_size,
           std::string* reply);
  // Sends a control request to OVirtualRobot and returns its status.  Stores the request's result
  // in `*result`, unless `result` is null.
  OStatus Control(ControlRequest request, const std::string& param, std::string* result = nullptr);
  OStatus ControlGains(ControlRequest request, OPrimitiveID id, const word gains[6]);
  OStatus ReadGains(ControlRequest request, OPrimitiveID id, word gains[6]);
  OStatus RefuseCall(const char* function);
  // Returns the services of this run's own robot, which execute the OPENR call `function`.  Warns
  // that the call does not reach the real robot, because nobody knows the form of the message that
  // would carry it.
  RobotServices& ServicesFor(const char* function) override;

  System* const system_;
  const ObjectId gateway_;
  const uint32_t selector_;
  std::unique_ptr<RobotServices> local_;  // null only in Remove(), which moves the pointer out
};

}  // namespace openr_host
