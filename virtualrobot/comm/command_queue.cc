#include "virtualrobot/comm/command_queue.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "virtualrobot/robot/robot_parts.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {

bool CommandQueue::Add(RCRegion* region) {
  if (waiting_.size() >= kMax) return false;
  waiting_.emplace_back(region);
  ASSERT(waiting_.size() <= kMax, "{} vectors wait", waiting_.size());
  return true;
}

bool CommandQueue::ReleaseFinished(int64_t frame) {
  if (!playing_ || frame < end_) return false;
  // Clears elements_ before the region of the vector is released, because the elements point into
  // the memory of this region.
  elements_.clear();
  playing_.Release();
  return true;
}

void CommandQueue::Start(int64_t frame, std::vector<std::string>* problems) {
  ASSERT(!playing_, "a vector starts while another one plays");
  playing_ = std::move(waiting_.front());
  waiting_.pop_front();
  turn_.Next();
  const SentVector vector = ReadSentVector(playing_.get(), sizeof(OCommandInfo), "command vector",
                                           robot_->system, problems);
  if (vector.header != nullptr && !NamesItsMemory(vector, robot_->system)) {
    problems->push_back(
        "command vector: its memRegionID names other memory than it came in (made without "
        "NewCommandVectorData(), or its header copied); the robot would look for the commands "
        "there");
  }
  start_ = frame + WaitOf(vector, problems);
  if (vector.header != nullptr) robot_->optional.CopyFrom(*vector.header, problems);
  ReadCommandElements(vector, FrameNumber(start_), &robot_->primitives, &read_, problems);
  robot_->watch.VectorStarts(read_, robot_->body->state(), robot_->power.motor_power(),
                             robot_->power.pause(), problems);
  // The length of the command vector in frames.  Begins with 1, because a vector without elements
  // lasts one frame.
  uint32_t longest = 1;
  for (const CommandElement& command : read_) {
    uint32_t length = 0;
    for (int i = 0; i < command.frames; ++i) length += command.FrameLength(i);
    longest = std::max(longest, length);
    // An element that sets nothing is not played, but its length was counted above, because the
    // vector lasts as long as its longest element.
    if (command.primitive == nullptr || command.frames == 0) continue;
    elements_.push_back({command, 0, start_ + command.FrameLength(0)});
  }
  end_ = start_ + longest;
  FindFace(problems);
}

void CommandQueue::FindFace(std::vector<std::string>* problems) {
  // Searches all elements of the vector for the last light of the robot's face (the one with the
  // highest index), because the mode (A or B) of this light becomes the mode of all lights of the
  // face, and elements may come in any order.
  face_ = -1;
  bool a = false, b = false;
  for (size_t e = 0; e < elements_.size(); ++e) {
    const CommandElement& command = elements_[e].command;
    if (command.type != odataLED_COMMAND3 || !robot_->devices.OnFace(command.primitive->index))
      continue;
    if (face_ < 0 ||
        command.primitive->index > elements_[static_cast<size_t>(face_)].command.primitive->index) {
      face_ = static_cast<int>(e);
    }
    for (int i = 0; i < command.frames; ++i) {
      const OLED3Mode mode = command.Mode(i);
      a |= mode == oled3_MODE_A;
      b |= mode == oled3_MODE_B;
    }
  }
  if (a && b) {
    problems->push_back(
        "command vector: modes A and B for lights of one face; the mode of the last light holds "
        "for all of them");
  }
}

void CommandQueue::AnnounceFirst() {
  if (!playing_ && !waiting_.empty())
    turn_.Announce(SyncKeyOf(*waiting_.front()), &robot_->sync_keys);
}

void CommandQueue::Apply(int64_t frame, std::vector<std::string>* problems) {
  robot_->devices.set_commander(ObjectIdOf(subject_.GetOID()));
  if (!playing_ && !waiting_.empty() &&
      turn_.MayStart(SyncKeyOf(*waiting_.front()), robot_->sync_keys, problems)) {
    Start(frame, problems);
  }
  if (!playing_ || frame < start_) return;
  for (Element& element : elements_) {
    if (frame >= element.ends) {
      if (element.command_frame + 1 >= element.command.frames)
        continue;  // keeps the value of the last command frame, because the element is over
      ++element.command_frame;
      element.ends += element.command.FrameLength(element.command_frame);
    }
    element.command.Apply(element.command_frame, &robot_->devices);
  }
  if (face_ >= 0) {
    const Element& last = elements_[static_cast<size_t>(face_)];
    robot_->devices.SetFaceMode(last.command.Mode(last.command_frame));
  }
}

void CommandQueue::HashState(Hasher* hasher) const {
  hasher->Add(static_cast<uint64_t>(waiting_.size()));
  for (const RegionReference& region : waiting_) hasher->Add(region->MemID());
  hasher->Add(turn_.announced());
  hasher->Add(playing_ ? playing_->MemID() : 0);
  hasher->Add(start_);
  hasher->Add(end_);
  for (const Element& element : elements_) {
    hasher->Add(element.command.type);
    hasher->Add(element.command.frames);
    hasher->Add(element.command_frame);
    hasher->Add(element.ends);
  }
}

}  // namespace openr_host
