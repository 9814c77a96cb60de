#include "runtime/gateway/system_messages.h"

#include <OPENR/OPENRAPI.h>
#include <fmt/format.h>

#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/robot_services.h"
#include "runtime/gateway/gateway_stream.h"

namespace openr_host {
namespace {

static_assert(sizeof(OPowerStatus) == kPowerStatusBytes - 4);
static_assert(sizeof(OJointValue) == 16 && sizeof(OSensorValue) == 16);

template <typename T>
std::string BytesOf(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string StatusReply(OStatus status) {
  return EncodeWord(kStatusType) + EncodeWord(static_cast<uint32_t>(status));
}

std::string Open(RobotServices* services, const std::string& message) {
  std::string locator = message.substr(4, kLocatorBytes - 1);
  locator.resize(std::strlen(locator.c_str()));
  OPrimitiveID id = oprimitiveID_UNDEF;
  const OStatus status = services->OpenPrimitive(locator.c_str(), &id);
  return EncodeWord(kOpenReplyType) + EncodeWord(static_cast<uint32_t>(status)) + EncodeWord(id);
}

// Executes a request to the entry kControlSelector of OVirtualRobot, with the parameter `param`, by
// calling a function of `services`.  Returns the status of this function and puts its other results
// into `*result`.  Sets `*is_known` to false if `request` is unknown.
OStatus Control(RobotServices* services, ControlRequest request, const std::string& param,
                std::string* result, bool* is_known) {
  const OPrimitiveID id = WordIn(param, 0);
  word gains[6] = {};
  ASSERT(param.size() >= 4 + sizeof gains, "{} bytes", param.size());
  std::memcpy(gains, param.data() + 4, sizeof gains);
  const auto gains_back = [&](OStatus status) {
    *result = EncodeWord(id) + BytesOf(gains);
    return status;
  };
  const auto value_back = [&](auto value, auto get) {
    std::memset(static_cast<void*>(&value), 0, sizeof value);
    const OStatus status = get(&value);
    *result = BytesOf(value);
    return status;
  };
  switch (request) {
    case ControlRequest::kNewSyncKey: {
      OVRSyncKey key = 0;
      const OStatus status = services->NewSyncKey(&key);
      *result = EncodeWord(key);
      return status;
    }
    case ControlRequest::kCancelSyncKey:
      return services->CancelSyncKey(id);
    case ControlRequest::kEnableGain:
      return services->EnableJointGain(id);
    case ControlRequest::kDisableGain:
      return services->DisableJointGain(id);
    case ControlRequest::kSetGain:
      return services->SetJointGain(id, gains);
    case ControlRequest::kRegisterGain:
      return services->RegisterDefaultJointGain(id, gains);
    case ControlRequest::kSetDefaultGain:
      return services->SetDefaultJointGain(id);
    case ControlRequest::kGetGain:
      return gains_back(services->GetJointGain(id, gains));
    case ControlRequest::kGetDefaultGain:
      return gains_back(services->GetDefaultJointGain(id, gains));
    case ControlRequest::kJointValue:
      return value_back(OJointValue(), [&](auto* to) { return services->GetJointValue(id, to); });
    case ControlRequest::kSensorValue:
      return value_back(OSensorValue(), [&](auto* to) { return services->GetSensorValue(id, to); });
  }
  *is_known = false;
  return oNOT_SUPPORTED;
}

std::string AnswerControl(RobotServices* services, const std::string& message, std::string* why) {
  const uint32_t request = WordIn(message, 8);
  std::string result;
  bool is_known = true;
  const OStatus status = Control(services, static_cast<ControlRequest>(request),
                                 message.substr(kControlParamAt), &result, &is_known);
  if (!is_known) *why = fmt::format("request {} of {} is not carried", request, kVirtualRobot);
  std::string reply = message;
  reply.replace(4, 4, EncodeWord(static_cast<uint32_t>(status)));
  return reply.replace(kControlParamAt, result.size(), result);
}

std::string PowerStatus(RobotServices* services, uint32_t selector) {
  OPowerStatus status;
  services->GetPowerStatus(&status);
  return EncodeWord(kPowerType + selector) + BytesOf(status);
}

std::string RobotDesign(const std::string& design) {
  std::string name = design.substr(0, 31);
  name.resize(32, '\0');
  return EncodeWord(kRobotDesignSelector) + name + EncodeWord(oSUCCESS);
}

}  // namespace

uint32_t WordIn(const std::string& bytes, size_t offset) {
  uint32_t word = 0;
  if (offset + sizeof word <= bytes.size()) std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

std::string ControlMessage(ControlRequest request, const std::string& param) {
  std::string message = EncodeWord(kControlType) + EncodeWord(0) +
                        EncodeWord(static_cast<uint32_t>(request)) + std::string(12, '\0') +
                        EncodeWord(static_cast<uint32_t>(param.size())) + EncodeWord(0) + param;
  ASSERT(message.size() <= kControlBytes, "a parameter of {} bytes", param.size());
  message.resize(kControlBytes, '\0');
  return message;
}

std::string AnswerSystemMessage(RobotServices* services, const std::string& design,
                                const std::string& name, uint32_t selector,
                                const std::string& message, std::string* why) {
  const auto has = [&](size_t size) {
    if (message.size() < size)
      *why = fmt::format("a message of {} bytes to {}, entry {}, which takes {}", message.size(),
                         name, selector, size);
    return message.size() >= size;
  };
  if (name == kVirtualRobot) {
    if (selector == kOpenSelector) return has(4 + kLocatorBytes) ? Open(services, message) : "";
    if (selector == kCloseSelector)
      return has(12) ? StatusReply(services->ClosePrimitive(WordIn(message, 8))) : "";
    if (selector == kControlSelector)
      return has(kControlBytes) ? AnswerControl(services, message, why) : "";
  } else if (name == kPowerManager) {
    if (selector == kMotorPowerSelector)
      return has(8) ? StatusReply(services->SetMotorPower(WordIn(message, 4) != 0)) : "";
    if (selector == kPowerStatusSelector) return PowerStatus(services, selector);
  } else if (name == kDesignedRobot) {
    if (selector == kRobotDesignSelector) return RobotDesign(design);
  }
  *why = fmt::format("entry {} of {} is not carried", selector, name);
  return "";
}

}  // namespace openr_host
