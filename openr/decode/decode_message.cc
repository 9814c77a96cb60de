#include "openr/decode/decode_message.h"

#include <OPENR/ODataFormats.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/ObjcommTypes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <vector>

#include "Messages.h"
#include "MoverState.h"
#include "runtime/api/power_text.h"
#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/devices/primitive_locator.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

// Reads a value of the type T into `value`, from the place `offset` of `content`, the bytes of a
// message.  Returns false if `content` ends before the end of the value.  This can happen, because
// only the beginning of a long message is kept.
template <typename T>
bool ReadAt(const std::string& content, size_t offset, T* value) {
  if (offset > content.size() || content.size() - offset < sizeof(T)) return false;
  std::memcpy(value, content.data() + offset, sizeof(T));
  return true;
}

// Returns the text in an array of characters.  The text ends at the first NUL or at the end of the
// array.
template <size_t N>
std::string TextIn(const char (&text)[N]) {
  return std::string(text, strnlen(text, N));
}

// Converts an angle of OPEN-R, in 10^-6 rad, to degrees.
double DegreesOf(slongword urad) { return Degrees(urad * 1e-6); }

// Calls tell(info) for each element of a data vector; `info` describes the element, such as the
// commands for one primitive.  Returns all lines that `tell` has returned.  Stops when `tell`
// returns "", or at the end of `content`.  `content` has the bytes of the vector; the last bytes of
// a long vector may be missing.
template <typename Info, typename Tell>
std::string DecodeElements(const std::string& content, Tell tell) {
  ODataVectorInfo vector;
  if (!ReadAt(content, 0, &vector)) return "";
  std::string text;
  for (longword i = 0; i < vector.numData; ++i) {
    Info info;
    if (!ReadAt(content, vector.infoOffset + i * sizeof info, &info)) break;
    const std::string line = tell(info);
    if (line.empty()) break;
    text += line + "\n";
  }
  return text;
}

// Reads the last frame (8 ms) of an element of a data vector, such as the last command for one
// primitive, into `value`.  `info` describes the element.  Returns false if the element has no
// frame, or if `content`, the bytes of the vector, ends before the end of the frame.
template <typename Info, typename Value>
bool ReadLastFrame(const std::string& content, const Info& info, size_t frames_max, Value* value) {
  if (info.numFrames == 0) return false;
  const size_t last = std::min<size_t>(info.numFrames, frames_max) - 1;
  return ReadAt(content, info.dataOffset + last * sizeof *value, value);
}

std::string LocatorOf(const RobotModel& model, OPrimitiveID id) {
  const std::string* const locator = PrimitiveLocator(model, id);
  return locator == nullptr ? fmt::format("primitive {:#x}", id) : *locator;
}

// Converts the command `frame`, which a primitive gets in one frame (8 ms), to text.  `type` is the
// kind of the primitive's commands.
std::string CommandText(ODataType type, const OCommandValue& frame) {
  switch (type) {
    case odataJOINT_COMMAND:
    case odataJOINT_COMMAND2:
      return fmt::format("{:.2f} deg", DegreesOf(frame.value[0]));
    case odataLED_COMMAND2: {
      OLEDCommandValue2 led;
      std::memcpy(&led, &frame, sizeof led);
      return led.led == oledON ? "on" : led.led == oledOFF ? "off" : fmt::format("{}", led.led);
    }
    case odataLED_COMMAND3: {
      OLEDCommandValue3 led;
      std::memcpy(&led, &frame, sizeof led);
      return fmt::format("intensity {}", led.intensity);
    }
    default:
      return fmt::format("{}", frame.value[0]);
  }
}

// Returns a text with the command for each primitive in the last frame of a command vector.
std::string DecodeCommands(const RobotModel& model, const std::string& content) {
  return DecodeElements<OCommandInfo>(content, [&](const OCommandInfo& info) -> std::string {
    OCommandValue value;
    if (!ReadLastFrame(content, info, ocommandMAX_FRAMES, &value)) return "";
    return fmt::format("{} to {} in {} frames", LocatorOf(model, info.primitiveID),
                       CommandText(info.type, value), info.numFrames);
  });
}

// Returns a text with the value of each sensor in the last frame of a sensor vector.
std::string DecodeSensors(const RobotModel& model, const std::string& content) {
  return DecodeElements<OSensorFrameInfo>(content, [&](const OSensorFrameInfo& info) {
    OSensorValue value;
    if (!ReadLastFrame(content, info, osensorframeMAX_FRAMES, &value)) return std::string();
    const std::string name = LocatorOf(model, info.primitiveID);
    return info.type == odataJOINT_VALUE
               ? fmt::format("{} {:.2f} deg", name, DegreesOf(value.value))
               : fmt::format("{} {}", name, value.value);
  });
}

std::string JointName(const RobotModel& model, int joint) {
  const bool is_known = joint >= 0 && joint < static_cast<int>(model.joints.size());
  return is_known ? model.joints[static_cast<size_t>(joint)].name : fmt::format("joint {}", joint);
}

// Returns the sounds of a sound vector as text, without their samples.
std::string DecodeSounds(const RobotModel& model, const std::string& content) {
  return DecodeElements<OSoundInfo>(content, [&](const OSoundInfo& info) {
    std::string text = fmt::format("{} {} bytes, frame {}", LocatorOf(model, info.primitiveID),
                                   info.dataSize, info.frameNumber);
    // Leaves out the rate, the bits and the channels of a sound whose sampling rate is 0, because
    // programs that play a sound need not set these fields.
    if (info.samplingRate != 0)
      text += fmt::format(", {} Hz, {} bits, {}", info.samplingRate, info.bitsPerSample,
                          info.channel == osoundchannelSTEREO ? "stereo" : "mono");
    return text;
  });
}

// Returns the layers of a camera image as text, without their pixels.
std::string DecodeImages(const RobotModel&, const std::string& content) {
  static constexpr const char* kLayers[ofbkimageNUM_LAYERS] = {"H", "M", "L", "C"};
  size_t layer = 0;
  return DecodeElements<OFbkImageInfo>(content, [&](const OFbkImageInfo& info) -> std::string {
    if (layer == ofbkimageNUM_LAYERS) return "";
    return fmt::format("layer {} {} x {}, {}, {} bytes, frame {}", kLayers[layer++], info.width,
                       info.height,
                       info.type == odataFBK_CDT     ? "colour detection"
                       : info.type == odataFBK_YCrCb ? "YCrCb"
                                                     : "YCrCb with high-pass filter",
                       info.dataSize, info.frameNumber);
  });
}

std::string MotorText(const RobotModel& model, Sint32 joint, const char* state) {
  return joint == MOVER_ALL_JOINTS ? fmt::format("motor power {}", state)
                                   : fmt::format("motor of {} {}", JointName(model, joint), state);
}

std::string MoverCommandText(const RobotModel& model, const MoverCommand& command) {
  const std::string joint = JointName(model, command.joint);
  const std::string file = TextIn(command.file);
  switch (command.kind) {
    case moverkindPOSITION:
      return fmt::format("move {} to {:.2f} deg", joint, DegreesOf(command.value));
    case moverkindSPEED:
      return fmt::format("speed of {} at most {:.2f} deg/s", joint, command.value / 100.0);
    case moverkindACCELERATION:
      return fmt::format("acceleration of {} {:.2f} deg/s^2", joint, command.value / 100.0);
    case moverkindTRACK:
      return fmt::format("{} to {:.2f} deg in {} frames", joint, DegreesOf(command.value),
                         command.frames);
    case moverkindPLAY:
      return fmt::format("play {}, {} times", file, command.loops) +
             (command.keyFramesPerVector == 0
                  ? ""
                  : fmt::format(", {} key frames per vector", command.keyFramesPerVector));
    case moverkindSTOP:
      return "stop the motion";
    case moverkindMOTOR_OFF:
      return MotorText(model, command.joint, "off");
    case moverkindMOTOR_ON:
      return MotorText(model, command.joint, "on");
    case moverkindGAINS:
      return fmt::format("gains of {}: P {}, I {}, D {}", joint, command.gain[0], command.gain[1],
                         command.gain[2]);
    default:
      return fmt::format("command {}", command.kind);
  }
}

// Returns the commands in `content`, which are of the type MoverCommand, as text.  A notification
// may have several commands.
std::string DecodeMoverCommands(const RobotModel& model, const std::string& content) {
  MoverCommand command;
  std::string text;
  for (size_t at = 0; ReadAt(content, at, &command); at += sizeof command)
    text += MoverCommandText(model, command) + "\n";
  return text;
}

std::string DecodeBatch(const RobotModel& model, const std::string& content) {
  BatchMoverCommand command;
  if (!ReadAt(content, 0, &command)) return "";
  std::string text;
  for (size_t i = 0; i < model.joints.size() && i < MAX_JOINTS; ++i) {
    const BatchJoint& joint = command.joint[i];
    const std::string goal = joint.flags & batchPOSITION_GIVEN
                                 ? fmt::format("to {:.2f} deg", DegreesOf(joint.position))
                                 : "stays";
    text += fmt::format("{} {}, at most {:.2f} deg/s, {:.2f} deg/s^2{}\n", model.joints[i].name,
                        goal, joint.speed / 100.0, joint.acceleration / 100.0,
                        joint.flags & batchMOTOR_OFF ? ", motor off" : "");
  }
  return text;
}

std::string DecodeSetValue(const RobotModel& model, const std::string& content) {
  SetValueMessage message;
  // Reads the last SetValueMessage only, because a notification may have several of them and the
  // last one is the newest.
  if (content.size() < sizeof message ||
      !ReadAt(content, content.size() - sizeof message, &message))
    return "";
  std::string text = fmt::format("state {}", MoverStateName(message.state));
  if (message.keyFrame >= 0) text += fmt::format(", key frame {}", message.keyFrame);
  const std::string file = TextIn(message.file);
  if (!file.empty()) text += fmt::format(", motion {}", file);
  if (message.isOver != 0) text += " is over";
  if (message.motorsOff != 0) text += ", motor power off";
  for (size_t i = 0; i < model.plungers.size() && i < 8; ++i) {
    if (message.earMask >> i & 1)
      text += fmt::format("\n{} {}", model.plungers[i].name, message.earOn >> i & 1 ? "on" : "off");
  }
  for (size_t i = 0; i < model.joints.size() && i < MAX_JOINTS; ++i) {
    text += fmt::format("\n{}: commanded {:.2f}, measured {:.2f} deg", model.joints[i].name,
                        DegreesOf(message.commanded[i]), DegreesOf(message.measured[i]));
  }
  return text;
}

std::string DecodeLedEar(const RobotModel& model, const std::string& content) {
  LedEarState state;
  if (!ReadAt(content, 0, &state)) return "";
  std::string text;
  for (size_t i = 0; i < model.leds.size() && i < 32; ++i) {
    if (state.ledMask >> i & 1)
      text += fmt::format("{} {}\n", model.leds[i].name, state.ledOn >> i & 1 ? "on" : "off");
  }
  for (size_t i = 0; i < model.plungers.size() && i < 32; ++i) {
    if (state.earMask >> i & 1)
      text += fmt::format("{} {}\n", model.plungers[i].name, state.earOn >> i & 1 ? "on" : "off");
  }
  return text;
}

std::string DecodeMainExecution(const RobotModel&, const std::string& content) {
  MainExecutionMessage message;
  if (!ReadAt(content, 0, &message)) return "";
  return fmt::format("state {}", MoverStateName(message.state));
}

std::string DecodeReady(const std::string& content) {
  int32_t words[2];
  if (!ReadAt(content, 0, &words)) return "";
  const char* const kind = words[0] == objcommCMD_ASSERT_READY     ? "ready (assert)"
                           : words[0] == objcommCMD_DEASSERT_READY ? "not ready (deassert)"
                                                                   : "ready";
  return words[1] == 0 ? kind : fmt::format("{}, gives back {} regions", kind, words[1]);
}

// Returns a text for `content` if it is a message of the system to an object, or the object's
// answer to such a message; else "".  The first word of these messages is the type of the message.
std::string DecodeSystemMessage(const std::string& content) {
  OMessageType type{};
  if (!ReadAt(content, 0, &type)) return "";
  OPowerStatusMessage power;
  if (type == omsgPOWER_STATUS && content.size() == sizeof power && ReadAt(content, 0, &power))
    return PowerSummary(power.powerStatus);
  OStatusMessage status;
  if (type == omsgOSTATUS && content.size() == sizeof status && ReadAt(content, 0, &status))
    return fmt::format("status {}", status.status);
  OReasonMessage reason;
  if (type == omsgREASON && content.size() == sizeof reason && ReadAt(content, 0, &reason))
    return reason.reason == oreasonBOOT       ? "boot"
           : reason.reason == oreasonSHUTDOWN ? "shutdown"
                                              : fmt::format("reason {}", reason.reason);
  OConnectMessage connect;
  if (type == omsgCONNECT && content.size() == sizeof connect && ReadAt(content, 0, &connect))
    return fmt::format("{} {}",
                       connect.command == oconnectcmdCONNECT ? "connect to" : "disconnect from",
                       TextIn(connect.subName));
  OControlMessage control;
  if (type == omsgCONTROL_V21 && content.size() == sizeof control && ReadAt(content, 0, &control)) {
    const bool adds = control.command == objcommCMD_ADDOBSERVER ||
                      control.command == objcommCMD_ADDOBSERVER_SELF ||
                      control.command == objcommCMD_ADDOBSERVER_V22;
    return fmt::format("{} an observer of {}", adds ? "add" : "remove", TextIn(control.subName));
  }
  OControlReplyMessage reply;
  if (type == omsgCONTROL_REPLY_V21 && content.size() == sizeof reply && ReadAt(content, 0, &reply))
    return fmt::format("status {}", reply.status);
  return "";
}

// Returns content of an unknown type as text: the characters if all are printable, else the content
// as numbers of 32 bits.
std::string DecodeUnknown(const std::string& content) {
  std::string text = content.substr(0, 256);
  while (text.ends_with('\0')) text.pop_back();
  const auto is_printable = [](unsigned char c) { return std::isprint(c) != 0 || c == '\n'; };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_printable))
    return fmt::format("\"{}\"", text);
  text.clear();
  for (size_t i = 0; i < 16; ++i) {
    int32_t number;
    if (!ReadAt(content, 4 * i, &number)) break;
    text += fmt::format("{}{}", i == 0 ? "" : " ", number);
  }
  return text;
}

// Returns the type of the data in a notification, such as MoverCommand.  `entry` is the name of a
// service or the name of an entry.  The name of an entry is the name of its service and then the
// kind of the entry, such as " (Notify)".  Returns "" for an entry of another kind, such as "
// (Ready)", because it gets no notifications.
std::string TypeOfEntry(const std::string& entry) {
  const size_t kind = entry.find(" (");
  if (kind != std::string::npos && entry.substr(kind) != " (Notify)") return "";
  return TypeOfService(entry);
}

constexpr std::string_view kStackPrefix = "IPStack: ";

}  // namespace

std::string TypeOfService(const std::string& service) {
  const size_t first = service.find('.');
  const size_t second = service.find('.', first + 1);
  const size_t third = service.find('.', second + 1);
  return third == std::string::npos ? "" : service.substr(second + 1, third - second - 1);
}

std::string DecodeContent(const RobotModel& model, const std::string& entry,
                          const std::string& content) {
  using Decode = std::string (*)(const RobotModel&, const std::string&);
  static const std::map<std::string, Decode> known = {
      {"OCommandVectorData", &DecodeCommands},       {"OSensorFrameVectorData", &DecodeSensors},
      {"OSoundVectorData", &DecodeSounds},           {"OFbkImageVectorData", &DecodeImages},
      {"MoverCommand", &DecodeMoverCommands},        {"BatchMoverCommand", &DecodeBatch},
      {"SetValueMessage", &DecodeSetValue},          {"LedEarState", &DecodeLedEar},
      {"MainExecutionMessage", &DecodeMainExecution}};
  if (content.starts_with(kStackPrefix)) return content;
  if (entry.ends_with("(Ready)")) return DecodeReady(content);
  const std::string type = TypeOfEntry(entry);
  const auto found = known.find(type);
  std::string text = found != known.end() ? found->second(model, content)
                     : type.empty()       ? DecodeSystemMessage(content)
                                          : "";
  while (text.ends_with('\n')) text.pop_back();
  return text.empty() ? DecodeUnknown(content) : text;
}

std::string DecodeReceived(const System& system, ObjectId target, uint32_t selector,
                           const std::string& content) {
  static const RobotModel no_model{};
  const Object* const object = system.object(target);
  if (object == nullptr || content.empty() || object->robot >= system.robot_count()) return "";
  const auto* const robot =
      dynamic_cast<const VirtualRobot*>(system.robot(object->robot).services.get());
  return DecodeContent(robot == nullptr ? no_model : robot->model(), object->EntryName(selector),
                       content);
}

std::string DecodeHandled(const System& system, const Message& message) {
  std::string content;
  if (message.kind == PayloadKind::kNotify) {
    // Looks the regions of the notification up by their ids.  The pointers of the message may lead
    // to regions that do not exist any more, but an id is never used again.
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    // Limits the number of the notification's regions, because the handler may have damaged the
    // message before it crashed.
    const int count = std::min<int>(notify.numOfData, MAX_NUM_DATA);
    for (int i = 0; i < count; ++i) {
      const TransferedData& data = notify.data[i];
      const char* const base = system.regions().BaseOf(data.memID);
      const size_t bytes = system.regions().SizeOf(data.memID);
      if (base == nullptr || data.offset > bytes || data.size > bytes - data.offset) return "";
      // Limits the bytes of all regions together, so that bytes are missing only at the end of
      // `content`.  If each region were cut separately, the region after a cut region would begin
      // at a wrong place in `content`, and wrong values would be decoded.
      content.append(base + data.offset, std::min(data.size, kDecodedBytesMax - content.size()));
    }
  } else {
    content = ContentOf(message);
  }
  return DecodeReceived(system, message.target, message.is_reply ? UNDEF : message.selector,
                        content);
}

std::string OneLineOf(const std::string& text, size_t size_max) {
  ASSERT(size_max >= 3, "no room for the mark '...' in {} characters", size_max);
  std::string line;
  for (const char c : text) {
    if (line.size() > size_max) break;
    c == '\n' ? line += "; " : line += c;
  }
  if (line.size() <= size_max) return line;
  return line.substr(0, size_max - 3) + "...";
}

std::string MessageText(uint64_t number, const std::string& said) {
  constexpr size_t kSaidMax = 60;
  return said.empty() ? fmt::format("message {}", number)
                      : fmt::format("message {}: {}", number, OneLineOf(said, kSaidMax));
}

std::string MessageInParentheses(uint64_t number, const std::string& said) {
  return number == 0 ? "" : fmt::format(" ({})", MessageText(number, said));
}

std::string_view ContentView(const Message& message, std::string* copy) {
  if (message.kind != PayloadKind::kHashed) return PayloadView(message, copy);
  // Returns no content for a message without an antEnvMsg, the header of messages of the network
  // stack.  Such a message only wakes an object whose wait has timed out.
  if (message.size < sizeof(antEnvMsg)) return {};
  const auto& request = *reinterpret_cast<const antEnvMsg*>(message.payload);
  if (message.size < AntMessageSize(request)) return {};
  *copy = kStackPrefix;
  *copy += AntMessageText(request, ObjectIdOf(request.sender) != message.sender);
  return *copy;
}

std::string ContentOf(const Message& message) {
  std::string copy;
  return std::string(ContentView(message, &copy));
}

}  // namespace openr_host
