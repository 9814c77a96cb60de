#include "virtualrobot/command_queue.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/core/hasher.h"
#include "virtualrobot/sync_keys.h"

namespace openr_host {
namespace {

constexpr uint32_t kEarFrames = 16;  // 128 ms for one Joint3 command (seed report, 5.3.4)

// Robot frames that command frame `i` of an element lasts.
uint32_t FrameLength(const OCommandInfo& info, const OCommandData& data, int i) {
  const OCommandValue* const value = &data.value[i];
  uint32_t length = 1;
  switch (info.type) {
    case odataJOINT_COMMAND3:
      length = kEarFrames;
      break;
    case odataJOINT_COMMAND4:
      length = reinterpret_cast<const OJointCommandValue4*>(value)->period;
      break;
    case odataLED_COMMAND2:
      length = reinterpret_cast<const OLEDCommandValue2*>(value)->period;
      break;
    case odataLED_COMMAND3:
      length = reinterpret_cast<const OLEDCommandValue3*>(value)->period;
      break;
    default:
      break;
  }
  return std::max<uint32_t>(length, 1);  // a period of 0 plays like 1
}

bool TypeFits(const Primitive& primitive, ODataType type) {
  switch (primitive.kind) {
    case PrimitiveKind::kJoint:
      return type == odataJOINT_COMMAND2;
    case PrimitiveKind::kPlunger:
      return type == odataJOINT_COMMAND3 || type == odataJOINT_COMMAND4;
    case PrimitiveKind::kLed:
      return type == odataLED_COMMAND2 || type == odataLED_COMMAND3;
    default:
      return false;
  }
}

}  // namespace

bool CommandQueue::Add(RCRegion* region) {
  if (waiting_.size() >= kMax) return false;
  waiting_.push_back(region);
  return true;
}

RCRegion* CommandQueue::TakeFinished(int64_t frame) {
  if (playing_ == nullptr || frame < end_) return nullptr;
  RCRegion* const finished = playing_;
  playing_ = nullptr;
  elements_.clear();
  return finished;
}

void CommandQueue::Start(int64_t frame, PrimitiveTable* primitives,
                         std::vector<std::string>* problems) {
  playing_ = waiting_.front();
  waiting_.pop_front();
  announced_ = false;
  start_ = frame + vector()->vectorInfo.wait;
  uint32_t longest = 1;  // an empty vector ends with the frame
  const longword count = std::min(vector()->vectorInfo.numData, vector()->vectorInfo.maxNumData);
  for (int i = 0; i < static_cast<int>(count); ++i) {
    OCommandInfo& info = *vector()->GetInfo(i);
    const OCommandData& data = *vector()->GetData(i);
    info.numFrames = std::min<longword>(info.numFrames, ocommandMAX_FRAMES);
    info.frameNumber = FrameNumber(start_);
    Element element;
    element.info = i;
    element.primitive = primitives->Find(info.primitiveID);
    for (int f = 0; f < static_cast<int>(info.numFrames); ++f)
      element.length += FrameLength(info, data, f);
    longest = std::max(longest, element.length);
    if (element.primitive == nullptr || !element.primitive->opened) {
      problems->push_back(
          fmt::format("command vector: element {} of {} names primitive {:#x}, which {}; it is "
                      "ignored (elements "
                      "declared with SetNumData() and never filled make joints jump on the robot)",
                      i, count, info.primitiveID,
                      element.primitive == nullptr ? "the robot does not have" : "nobody opened"));
    } else if (!TypeFits(*element.primitive, info.type)) {
      problems->push_back(
          fmt::format("command vector: element {} has data type {}, which does not fit {}; it "
                      "is ignored",
                      i, info.type, element.primitive->locator));
    } else if (info.numFrames > 0) {
      element.ends = start_ + FrameLength(info, data, 0);
      elements_.push_back(element);
    }
  }
  end_ = start_ + longest;
}

void CommandQueue::Announce(SyncKeys* sync_keys) {
  if (playing_ != nullptr || waiting_.empty() || announced_) return;
  sync_keys->Arrive(VectorOf(waiting_.front())->vectorInfo.syncKey);
  announced_ = true;
}

void CommandQueue::Apply(int64_t frame, PrimitiveTable* primitives, Devices* devices,
                         SyncKeys* sync_keys, std::vector<std::string>* problems) {
  if (playing_ == nullptr && !waiting_.empty() &&
      sync_keys->MayStart(VectorOf(waiting_.front())->vectorInfo.syncKey)) {
    Start(frame, primitives, problems);
  }
  if (playing_ == nullptr || frame < start_) return;
  for (Element& element : elements_) {
    const OCommandInfo& info = *vector()->GetInfo(element.info);
    if (frame >= element.ends) {
      if (element.command_frame + 1 >= static_cast<int>(info.numFrames))
        continue;  // holds its last value
      ++element.command_frame;
      element.ends += FrameLength(info, *vector()->GetData(element.info), element.command_frame);
    }
    ApplyElement(element, devices);
  }
}

void CommandQueue::ApplyElement(const Element& element, Devices* devices) {
  const OCommandInfo& info = *vector()->GetInfo(element.info);
  const OCommandValue* const value = &vector()->GetData(element.info)->value[element.command_frame];
  const auto index = static_cast<size_t>(element.primitive->index);
  switch (info.type) {
    case odataJOINT_COMMAND2:
      devices->joints[index].target_urad =
          reinterpret_cast<const OJointCommandValue2*>(value)->value;
      break;
    case odataJOINT_COMMAND3:
      devices->plungers[index].state = reinterpret_cast<const OJointCommandValue3*>(value)->value;
      break;
    case odataJOINT_COMMAND4:
      devices->plungers[index].state = reinterpret_cast<const OJointCommandValue4*>(value)->value;
      break;
    case odataLED_COMMAND2:
      devices->leds[index].intensity =
          reinterpret_cast<const OLEDCommandValue2*>(value)->led == oledON ? 1 : 0;
      break;
    case odataLED_COMMAND3:
      devices->leds[index].intensity = reinterpret_cast<const OLEDCommandValue3*>(value)->intensity;
      break;
    default:
      break;
  }
}

void CommandQueue::HashState(Hasher* hasher) const {
  hasher->Add(static_cast<uint64_t>(waiting_.size()));
  hasher->Add(playing_ != nullptr);
  hasher->Add(start_);
  hasher->Add(end_);
  for (const Element& element : elements_) {
    hasher->Add(element.info);
    hasher->Add(element.command_frame);
    hasher->Add(element.ends);
  }
}

}  // namespace openr_host
