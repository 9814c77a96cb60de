#include "openr/inspect/decode_message.h"

#include <OPENR/ODataFormats.h>
#include <OPENR/ObjcommTypes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstring>
#include <map>
#include <vector>

#include "Messages.h"
#include "MoverState.h"
#include "virtualrobot/det_math.h"
#include "virtualrobot/primitive_table.h"

namespace openr_host {
namespace {

// Reads a T at `offset` of `content` into `value`.  Returns false if `content` ends before, which
// is possible because the content of a message may have been cut.
template <typename T>
bool ReadAt(const std::string& content, size_t offset, T* value) {
  if (offset > content.size() || content.size() - offset < sizeof(T)) return false;
  std::memcpy(value, content.data() + offset, sizeof(T));
  return true;
}

// Converts an angle of OPEN-R, in 10^-6 rad, to degrees.
double DegreesOf(slongword urad) { return Degrees(urad * 1e-6); }

std::string LocatorOf(PrimitiveTable* table, OPrimitiveID id) {
  const Primitive* const primitive = table->Find(id);
  return primitive == nullptr ? fmt::format("primitive {:#x}", id) : primitive->locator;
}

// Returns the last frame of each primitive of a command vector as text.
std::string DecodeCommands(const RobotModel& model, const std::string& content) {
  PrimitiveTable table(model);
  ODataVectorInfo vector;
  if (!ReadAt(content, 0, &vector)) return "";
  std::string text;
  for (longword i = 0; i < vector.numData; ++i) {
    OCommandInfo info;
    OCommandValue value;
    if (!ReadAt(content, vector.infoOffset + i * sizeof info, &info) || info.numFrames == 0) break;
    const size_t last = std::min<size_t>(info.numFrames, ocommandMAX_FRAMES) - 1;
    if (!ReadAt(content, info.dataOffset + last * sizeof value, &value)) break;
    const std::string name = LocatorOf(&table, info.primitiveID);
    text += info.type == odataJOINT_COMMAND2
                ? fmt::format("{} to {:.2f} deg in {} frames\n", name, DegreesOf(value.value[0]),
                              info.numFrames)
                : fmt::format("{} to {} in {} frames\n", name, value.value[0], info.numFrames);
  }
  return text;
}

// Returns the last frame of each element of a sensor vector as text.
std::string DecodeSensors(const RobotModel& model, const std::string& content) {
  PrimitiveTable table(model);
  ODataVectorInfo vector;
  if (!ReadAt(content, 0, &vector)) return "";
  std::string text;
  for (longword i = 0; i < vector.numData; ++i) {
    OSensorFrameInfo info;
    OSensorValue value;
    if (!ReadAt(content, vector.infoOffset + i * sizeof info, &info) || info.numFrames == 0) break;
    const size_t last = std::min<size_t>(info.numFrames, osensorframeMAX_FRAMES) - 1;
    if (!ReadAt(content, info.dataOffset + last * sizeof value, &value)) break;
    const std::string name = LocatorOf(&table, info.primitiveID);
    text += info.type == odataJOINT_VALUE
                ? fmt::format("{} {:.2f} deg\n", name, DegreesOf(value.value))
                : fmt::format("{} {}\n", name, value.value);
  }
  return text;
}

std::string JointName(const RobotModel& model, int joint) {
  const bool is_known = joint >= 0 && joint < static_cast<int>(model.joints.size());
  return is_known ? model.joints[static_cast<size_t>(joint)].name : fmt::format("joint {}", joint);
}

std::string DecodeMoverCommand(const RobotModel& model, const std::string& content) {
  MoverCommand command;
  if (!ReadAt(content, 0, &command)) return "";
  const std::string joint = JointName(model, command.joint);
  const std::string file(command.file, strnlen(command.file, sizeof command.file));
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
      return fmt::format("play {}, {} times", file, command.loops);
    case moverkindSTOP:
      return "stop the motion";
    default:
      return fmt::format("command {}", command.kind);
  }
}

std::string DecodeSetValue(const RobotModel& model, const std::string& content) {
  SetValueMessage message;
  // Reads the last message only, because a notification may have several messages and the last one
  // is the newest.
  if (content.size() < sizeof message ||
      !ReadAt(content, content.size() - sizeof message, &message))
    return "";
  std::string text = fmt::format("state {}", MoverStateName(message.state));
  if (message.keyFrame >= 0) text += fmt::format(", key frame {}", message.keyFrame);
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

// Returns content of an unknown type as text if all of it is printable, else as 32-bit numbers.
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

// Returns the data type in the name of a service, the third of its four parts.
std::string TypeOf(const std::string& service) {
  const size_t first = service.find('.');
  const size_t second = service.find('.', first + 1);
  const size_t third = service.find('.', second + 1);
  return third == std::string::npos ? "" : service.substr(second + 1, third - second - 1);
}

}  // namespace

std::string DecodeContent(const RobotModel& model, const std::string& entry,
                          const std::string& content) {
  using Decode = std::string (*)(const RobotModel&, const std::string&);
  static const std::map<std::string, Decode> known = {
      {"OCommandVectorData", &DecodeCommands}, {"OSensorFrameVectorData", &DecodeSensors},
      {"MoverCommand", &DecodeMoverCommand},   {"SetValueMessage", &DecodeSetValue},
      {"LedEarState", &DecodeLedEar},          {"MainExecutionMessage", &DecodeMainExecution}};
  if (entry.ends_with("(Ready)")) return DecodeReady(content);
  const auto found = known.find(TypeOf(entry));
  std::string text = found == known.end() ? "" : found->second(model, content);
  while (text.ends_with('\n')) text.pop_back();
  return text.empty() ? DecodeUnknown(content) : text;
}

}  // namespace openr_host
