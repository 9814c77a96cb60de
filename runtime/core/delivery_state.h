// DeliveryState: all reasons why a message to an object may not be passed to its handler at once.
// For example, the robot is off, or a handler of the object waits or has the processor.
#pragma once

#include <utility>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/core/message.h"

namespace openr_host {

class Fiber;

class DeliveryState {
 public:
  // A flag that is true if a message to the object needs nothing but a call of its handler.  Every
  // delivery reads this flag.  So it lies not in the DeliveryState, but on a cache line of the
  // object that every delivery reads anyway.  Only the object's DeliveryState can change the flag.
  class PlainFlag {
   public:
    explicit PlainFlag(const DeliveryState& state) : is_plain_(state.IsPlain()) {}
    explicit operator bool() const { return is_plain_; }

   private:
    friend class DeliveryState;
    bool is_plain_;
  };

  // `flag` is the PlainFlag that this DeliveryState sets, but not in this constructor, because the
  // Object makes the flag after this DeliveryState.  `is_image` tells whether the object was loaded
  // from a file.  The flag of an image is never true, because a message to an image needs more than
  // a call of the handler: the dispatcher looks for floating-point faults, and may measure the use
  // of the stack.
  DeliveryState(PlainFlag* flag, bool is_image) : flag_(flag), is_image_(is_image) {}
  DeliveryState(const DeliveryState&) = delete;
  DeliveryState& operator=(const DeliveryState&) = delete;

  // Returns whether the robot is off.  Messages to the object are dropped while the robot is off.
  bool is_off() const { return is_off_; }
  void set_off(bool is_off) {
    is_off_ = is_off;
    SetFlag();
  }

  // Returns whether a handler of the object has the processor (cpu.h).
  bool is_busy() const { return is_busy_; }
  void set_busy(bool is_busy) {
    is_busy_ = is_busy;
    SetFlag();
  }

  // The stack of the handler while the handler waits; null if no handler waits.
  Fiber* blocked() const { return blocked_; }
  void set_blocked(Fiber* blocked) {
    blocked_ = blocked;
    SetFlag();
  }

  // Messages that the object cannot handle yet, because its handler waits or has the processor
  // (cpu.h), or because the object is in its boot (ObjectManager::IsTooEarly()).  The oldest
  // message is first.
  const std::vector<OwnedMessage>& held() const { return held_; }
  void Hold(OwnedMessage message) {
    held_.push_back(std::move(message));
    SetFlag();
  }
  // Takes the newest of the messages that the object could not handle yet.  REQUIRES: held() is not
  // empty.
  OwnedMessage TakeNewestHeld() {
    ASSERT(!held_.empty());
    OwnedMessage message = std::move(held_.back());
    held_.pop_back();
    SetFlag();
    return message;
  }

 private:
  bool IsPlain() const {
    return !is_image_ && !is_off_ && !is_busy_ && blocked_ == nullptr && held_.empty();
  }
  // Sets the PlainFlag, which is true if a message to the object needs nothing but a call of its
  // handler.  Every function that changes a member of this class calls this function at its end.
  void SetFlag() { flag_->is_plain_ = IsPlain(); }

  PlainFlag* const flag_;
  const bool is_image_;
  bool is_off_ = false;
  bool is_busy_ = false;
  Fiber* blocked_ = nullptr;
  std::vector<OwnedMessage> held_;
};

}  // namespace openr_host
