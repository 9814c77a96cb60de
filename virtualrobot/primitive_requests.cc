// Answers requests by a table with one row per request (robot.md, 13.3).
#include "virtualrobot/primitive_requests.h"

#include <fmt/format.h>

#include <cstring>

#include "runtime/core/current.h"
#include "runtime/core/object.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

// The arguments of a call of ControlPrimitive(), by which an object sends a request to a primitive.
// The sizes of `param` and `result` are those of the request's row in kRows: ControlPrimitive() has
// checked them.
struct RequestCall {
  VirtualRobot& robot;
  RobotParts& parts;
  const Primitive& primitive;
  OPrimitiveID id;
  const void* param;
  void* result;
};

struct PrimitiveRequests {
  struct Row {
    OPrimitiveRequest request;
    OPrimitiveType type;  // type of the primitives that accept the request
    size_t param_size, result_size;
    OStatus (*act)(const RequestCall& call);
  };

  static constexpr size_t kAnySize = SIZE_MAX;

  template <typename T>
  static T ParamOf(const RequestCall& call, T value) {
    std::memcpy(static_cast<void*>(&value), call.param, sizeof value);
    return value;
  }
  static longword CameraParam(const RequestCall& call) {
    return ParamOf(call, OPrimitiveControl_CameraParam(0)).camparam;
  }
  static OStatus Nothing(const RequestCall&) { return oSUCCESS; }
  static OStatus NotSupported(const RequestCall&) { return oNOT_SUPPORTED; }

  // Carries out a request of ControlPrimitive() that only switches a setting of a device on or off.
  template <auto device, auto set, bool on>
  static OStatus Switch(const RequestCall& call) {
    (call.parts.*device.*set)(on);
    return oSUCCESS;
  }
  // Carries out a request of ControlPrimitive() that changes a setting of the camera.  Refuses a
  // value that OPEN-R does not define.
  template <auto set>
  static OStatus Choose(const RequestCall& call) {
    return (call.parts.camera.*set)(CameraParam(call)) ? oSUCCESS : oINVALID_ARG;
  }

  static OStatus SetVolume(const RequestCall& call);
  static OStatus SetSoundType(const RequestCall& call);
  static OStatus GetSoundType(const RequestCall& call);
  static OStatus SetJoint2(const RequestCall& call);
  static OStatus GetJoint2(const RequestCall& call);
  static OStatus SetJoint4(const RequestCall& call);
  static OStatus SetLed2(const RequestCall& call);
  static OStatus SetLed3(const RequestCall& call);

  static const Row kRows[];
  static const Row* Find(OPrimitiveRequest request, OPrimitiveType type);
};

// Sets the speaker's volume.  Accepts a volume above -10 dB with a warning, because such a volume
// may damage the circuit of the robot (field-notes.md, 10.5).
OStatus PrimitiveRequests::SetVolume(const RequestCall& call) {
  const longword volume = ParamOf(call, OPrimitiveControl_SpeakerVolume(0)).volume;
  const auto loudness = [](longword v) { return static_cast<sword>(v & 0xffff); };
  if (loudness(volume) > loudness(ospkvol10dB)) {
    call.parts.Warn(
        fmt::format("speaker volume {:#x} is louder than ospkvol10dB ({:#x}); on the robot it may "
                    "damage the circuit (volumes are two's complement, 0 is loud)",
                    volume & 0xffff, ospkvol10dB));
  }
  call.parts.speaker.SetVolume(volume);
  return oSUCCESS;
}

OStatus PrimitiveRequests::SetSoundType(const RequestCall& call) {
  const longword type = ParamOf(call, OPrimitiveControl_SpeakerSoundType(0)).type;
  return call.parts.speaker.SetSoundType(type) ? oSUCCESS : oINVALID_ARG;
}

OStatus PrimitiveRequests::GetSoundType(const RequestCall& call) {
  const OPrimitiveControl_SpeakerSoundType result(call.parts.speaker.sound_type().type);
  std::memcpy(call.result, &result, sizeof result);
  return oSUCCESS;
}

OStatus PrimitiveRequests::SetJoint2(const RequestCall& call) {
  // Records the calling object as the commander of the joint, because SafePosture moves the joints
  // whose commander has crashed.
  call.parts.devices.set_commander(t_current.object == nullptr ? kNoObject : t_current.object->id);
  call.parts.devices.SetTarget(
      call.primitive.index, ParamOf(call, OPrimitiveControl_JointCommandValue2(0)).command.value);
  return oSUCCESS;
}

OStatus PrimitiveRequests::GetJoint2(const RequestCall& call) {
  return call.robot.GetJointValue(call.id, static_cast<OJointValue*>(call.result));
}

OStatus PrimitiveRequests::SetJoint4(const RequestCall& call) {
  call.parts.devices.plungers[static_cast<size_t>(call.primitive.index)].state =
      ParamOf(call, OPrimitiveControl_JointCommandValue4(0)).command.value;
  return oSUCCESS;
}

OStatus PrimitiveRequests::SetLed2(const RequestCall& call) {
  call.parts.devices.SetLed2(call.primitive.index,
                             ParamOf(call, OPrimitiveControl_LEDCommandValue2(0)).command.led);
  return oSUCCESS;
}

OStatus PrimitiveRequests::SetLed3(const RequestCall& call) {
  const auto param = ParamOf(call, OPrimitiveControl_LEDCommandValue3(0, oled3_MODE_A));
  const OLEDCommandValue3& command = param.command;
  call.parts.devices.SetLed3(call.primitive.index, command);
  if (call.parts.devices.OnFace(call.primitive.index)) call.parts.devices.SetFaceMode(command.mode);
  return oSUCCESS;
}

const PrimitiveRequests::Row PrimitiveRequests::kRows[] = {
    {oprmreqSPEAKER_MUTE_ON, oprimitiveSPEAKER, 0, 0,
     Switch<&RobotParts::speaker, &Speaker::set_mute, true>},
    {oprmreqSPEAKER_MUTE_OFF, oprimitiveSPEAKER, 0, 0,
     Switch<&RobotParts::speaker, &Speaker::set_mute, false>},
    {oprmreqSPEAKER_SET_VOLUME, oprimitiveSPEAKER, sizeof(OPrimitiveControl_SpeakerVolume), 0,
     SetVolume},
    {oprmreqSPEAKER_SET_SOUND_TYPE, oprimitiveSPEAKER, sizeof(OPrimitiveControl_SpeakerSoundType),
     0, SetSoundType},
    {oprmreqSPEAKER_GET_SOUND_TYPE, oprimitiveSPEAKER, 0,
     sizeof(OPrimitiveControl_SpeakerSoundType), GetSoundType},
    // Requests for volume and tuning of MIDI sound do nothing, because MIDI sound is not played.
    {oprmreqSPEAKER_SET_VOLUME_MIDI, oprimitiveSPEAKER, kAnySize, 0, Nothing},
    {oprmreqSPEAKER_MASTER_TUNING_MIDI, oprimitiveSPEAKER,
     sizeof(OPrimitiveControl_MasterTuningMIDI), 0, Nothing},

    {oprmreqMIC_UNI, oprimitiveMIC, 0, 0,
     Switch<&RobotParts::microphone, &Microphone::set_directional, true>},
    {oprmreqMIC_OMNI, oprimitiveMIC, 0, 0,
     Switch<&RobotParts::microphone, &Microphone::set_directional, false>},
    {oprmreqMIC_ALC_ON, oprimitiveMIC, 0, 0,
     Switch<&RobotParts::microphone, &Microphone::set_level_control, true>},
    {oprmreqMIC_ALC_OFF, oprimitiveMIC, 0, 0,
     Switch<&RobotParts::microphone, &Microphone::set_level_control, false>},

    {oprmreqCAM_SET_WHITE_BALANCE, oprimitiveFBKIMAGESENSOR, sizeof(OPrimitiveControl_CameraParam),
     0, Choose<&CameraDevice::SetWhiteBalance>},
    {oprmreqCAM_SET_GAIN, oprimitiveFBKIMAGESENSOR, sizeof(OPrimitiveControl_CameraParam), 0,
     Choose<&CameraDevice::SetGain>},
    {oprmreqCAM_SET_SHUTTER_SPEED, oprimitiveFBKIMAGESENSOR, sizeof(OPrimitiveControl_CameraParam),
     0, Choose<&CameraDevice::SetShutter>},
    // Refuses the request for a colour table, because it is not known how the 32 segments of the
    // table are packed into the 100 bytes of the answer.
    {oprmreqCAM_GET_CDT_TABLE, oprimitiveFBKIMAGESENSOR, sizeof(OPrimitiveControl_Cdt),
     sizeof(OPrimitiveControl_Cdt), NotSupported},
    {oprmreqCAM_AE_ON, oprimitiveFBKIMAGESENSOR, 0, 0,
     Switch<&RobotParts::camera, &CameraDevice::set_auto_exposure, true>},
    {oprmreqCAM_AE_OFF, oprimitiveFBKIMAGESENSOR, 0, 0,
     Switch<&RobotParts::camera, &CameraDevice::set_auto_exposure, false>},
    {oprmreqCAM_AWB_ON, oprimitiveFBKIMAGESENSOR, 0, 0,
     Switch<&RobotParts::camera, &CameraDevice::set_auto_white_balance, true>},
    {oprmreqCAM_AWB_OFF, oprimitiveFBKIMAGESENSOR, 0, 0,
     Switch<&RobotParts::camera, &CameraDevice::set_auto_white_balance, false>},

    {oprmreqJOINT2_SET_COMMAND, oprimitiveJOINT2, sizeof(OPrimitiveControl_JointCommandValue2), 0,
     SetJoint2},
    {oprmreqJOINT2_GET_VALUE, oprimitiveJOINT2, 0, sizeof(OPrimitiveControl_JointValue), GetJoint2},
    {oprmreqJOINT4_SET_COMMAND, oprimitiveJOINT4, sizeof(OPrimitiveControl_JointCommandValue4), 0,
     SetJoint4},
    {oprmreqLED2_SET_COMMAND, oprimitiveLED2, sizeof(OPrimitiveControl_LEDCommandValue2), 0,
     SetLed2},
    {oprmreqLED3_SET_COMMAND, oprimitiveLED3, sizeof(OPrimitiveControl_LEDCommandValue3), 0,
     SetLed3},
    // The table has no rows for the requests oprmreqBT_ATTACH, oprmreqBT_DETACH and
    // oprmreqSENSOR_WATCH_BT_SWITCH, because no model has the Bluetooth primitive.  These requests
    // are answered with oINVALID_ARG, like every request to a primitive that does not accept it.
};

const PrimitiveRequests::Row* PrimitiveRequests::Find(OPrimitiveRequest request,
                                                      OPrimitiveType type) {
  for (const Row& row : kRows) {
    if (row.request == request && row.type == type) return &row;
  }
  return nullptr;
}

OStatus CarryOutRequest(VirtualRobot* robot, OPrimitiveID id, OPrimitiveRequest request,
                        const void* param, size_t param_size, void* result, size_t result_size) {
  RobotParts& parts = robot->parts();
  const Primitive* const primitive = parts.primitives.Find(id);
  if (primitive == nullptr) return oINVALID_PRIMITIVE_ID;
  const auto* const row = PrimitiveRequests::Find(request, primitive->type);
  if (row == nullptr) {
    parts.Warn(fmt::format("ControlPrimitive: {} has no request {}", primitive->locator, request));
    return oINVALID_ARG;
  }
  // Checks the sizes of the parameter and of the result, so that a program that passes the wrong
  // structure does not make us read or write the memory beside the structure.
  const auto fits = [](size_t wanted, const void* data, size_t size) {
    return wanted == PrimitiveRequests::kAnySize || wanted == 0 ||
           (data != nullptr && size == wanted);
  };
  if (!fits(row->param_size, param, param_size) || !fits(row->result_size, result, result_size)) {
    parts.Warn(
        fmt::format("ControlPrimitive: request {} of {} takes {} bytes and answers {}, got room "
                    "for {} and {}",
                    request, primitive->locator, row->param_size, row->result_size,
                    param == nullptr ? 0 : param_size, result == nullptr ? 0 : result_size));
    return oINVALID_ARG;
  }
  if (!primitive->opened())
    parts.Warn(fmt::format("ControlPrimitive: nobody opened {}", primitive->locator));
  return row->act({*robot, parts, *primitive, id, param, result});
}

}  // namespace openr_host
