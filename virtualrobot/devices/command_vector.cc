#include "virtualrobot/devices/command_vector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/unset_command.h"

namespace openr_host {
namespace {

constexpr uint32_t kEarFrames = 16;  // duration of a command frame of an ear: 128 ms

ODataType CommandTypeOf(const Primitive& primitive) {
  switch (primitive.type) {
    case oprimitiveJOINT2:
      return odataJOINT_COMMAND2;
    case oprimitiveJOINT3:
      return odataJOINT_COMMAND3;
    case oprimitiveJOINT4:
      return odataJOINT_COMMAND4;
    case oprimitiveLED2:
      return odataLED_COMMAND2;
    case oprimitiveLED3:
      return odataLED_COMMAND3;
    default:
      return odataUNDEF;
  }
}

// Returns command frame `i` of `data` as a Value: the SDK's struct for a command, such as
// OLEDCommandValue3.  Returns a Value with a set point of 0 if the program never filled this
// command frame.
template <typename Value>
Value As(const OCommandData& data, int i) {
  static_assert(sizeof(Value) == sizeof(OCommandValue));
  Value value;
  std::memcpy(&value, &data.value[i], sizeof value);
  if (data.value[i].value[0] == kUnsetCommand) std::memset(&value, 0, sizeof(slongword));
  return value;
}

// Returns the reason why the element of a command vector cannot set `primitive`; "" when the
// element can set it.
std::string ElementProblem(const OCommandInfo& info, const Primitive* primitive) {
  if (primitive == nullptr || !primitive->opened()) {
    return fmt::format(
        "names primitive {:#x}, which {}; it is ignored (elements declared with SetNumData() and "
        "never filled make joints jump on the robot)",
        info.primitiveID, primitive == nullptr ? "the robot does not have" : "nobody opened");
  }
  if (CommandTypeOf(*primitive) != info.type) {
    return fmt::format("has data type {}, which does not fit {}; it is ignored", info.type,
                       primitive->locator);
  }
  return "";
}

// Returns the number of command frames of an element of a command vector, 0 to 16.  If the element
// names more than 16 frames, or if the program never filled some of its frames, describes this
// mistake in `problem`.
int CountFrames(const OCommandInfo& info, const OCommandData& data, std::string* problem) {
  const int frames = static_cast<int>(std::min<longword>(info.numFrames, ocommandMAX_FRAMES));
  if (info.numFrames > ocommandMAX_FRAMES) {
    *problem = fmt::format(
        "says {} frames; a vector has room for {}, the rest was written over "
        "the element behind it and is not played",
        info.numFrames, ocommandMAX_FRAMES);
  }
  // Looks for a command frame that still has the number kUnsetCommand, which NewCommandVectorData()
  // writes into every command frame: the program has never filled such a frame.
  for (int i = 0; i < frames; ++i) {
    if (data.value[i].value[0] != kUnsetCommand) continue;
    *problem = fmt::format(
        "says {} frames, of which frame {} was never filled; it plays as 0 (on "
        "the robot as whatever the memory held: joints shiver or go to "
        "extremes)",
        info.numFrames, i);
    break;
  }
  return frames;
}

}  // namespace

uint32_t CommandElement::FrameLength(int i) const {
  uint32_t length = 1;
  switch (type) {
    case odataJOINT_COMMAND3:
      length = kEarFrames;
      break;
    case odataJOINT_COMMAND4:
      length = As<OJointCommandValue4>(*data, i).period;
      break;
    case odataLED_COMMAND2:
      length = As<OLEDCommandValue2>(*data, i).period;
      break;
    case odataLED_COMMAND3:
      length = As<OLEDCommandValue3>(*data, i).period;
      break;
    default:
      break;
  }
  return std::max<uint32_t>(length, 1);
}

slongword CommandElement::Urad(int i) const {
  ASSERT(type == odataJOINT_COMMAND2, "type {}", type);
  return As<OJointCommandValue2>(*data, i).value;
}

OLED3Mode CommandElement::Mode(int i) const {
  ASSERT(type == odataLED_COMMAND3, "type {}", type);
  return As<OLEDCommandValue3>(*data, i).mode;
}

void CommandElement::Apply(int i, Devices* devices) const {
  ASSERT(primitive != nullptr && i >= 0 && i < frames, "frame {} of {}", i, frames);
  const auto index = static_cast<size_t>(primitive->index);
  switch (type) {
    case odataJOINT_COMMAND2:
      devices->SetTarget(primitive->index, Urad(i));
      break;
    case odataJOINT_COMMAND3:
      devices->plungers[index].state = As<OJointCommandValue3>(*data, i).value;
      break;
    case odataJOINT_COMMAND4:
      devices->plungers[index].state = As<OJointCommandValue4>(*data, i).value;
      break;
    case odataLED_COMMAND2:
      devices->SetLed2(primitive->index, As<OLEDCommandValue2>(*data, i).led);
      break;
    case odataLED_COMMAND3:
      devices->SetLed3(primitive->index, As<OLEDCommandValue3>(*data, i));
      break;
    default:
      break;
  }
}

void ReadCommandElements(const SentVector& vector, longword frame_number,
                         PrimitiveTable* primitives, std::vector<CommandElement>* elements,
                         std::vector<std::string>* problems) {
  elements->clear();
  for (int i = 0; i < vector.elements; ++i) {
    OCommandInfo& info = reinterpret_cast<OCommandVectorData*>(vector.header)->info[i];
    info.frameNumber = frame_number;
    std::string problem;
    CommandElement element;
    element.type = info.type;
    element.data =
        reinterpret_cast<const OCommandData*>(vector.At(info.dataOffset, sizeof(OCommandData)));
    const Primitive* const primitive = primitives->Find(info.primitiveID);
    // An element whose dataOffset is not the place of an OCommandData has no data and sets nothing.
    // The element is kept in the list, because it may be the longest element, which decides how
    // long the vector lasts.
    if (element.data == nullptr || info.dataOffset % alignof(OCommandData) != 0) {
      element.data = nullptr;
      problem = fmt::format(
          "has its data at offset {}, which is no place in the vector; it is "
          "ignored",
          info.dataOffset);
    } else {
      element.frames = CountFrames(info, *element.data, &problem);
      const std::string objection = ElementProblem(info, primitive);
      if (objection.empty()) {
        element.primitive = primitive;
      } else {
        problem = objection;
      }
    }
    if (!problem.empty()) {
      problems->push_back(
          fmt::format("command vector: element {} of {} {}", i, vector.elements, problem));
    }
    elements->push_back(element);
  }
}

}  // namespace openr_host
