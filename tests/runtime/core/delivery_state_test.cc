// DeliveryState: its flag is set only while nothing demands more than a call of the handler.
#include "runtime/core/delivery_state.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "runtime/core/fiber.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

class DeliveryStateTest : public testing::Test {
 protected:
  OwnedMessage NewMessage() { return system.NewMessage(kNoObject, 0); }
  bool IsPlain() const { return object.is_plain(); }

  Log log;
  System system;
  Object& object = system.AddObject<Recorder>(0, "a", &log)->host();
};

TEST_F(DeliveryStateTest, ANewObjectBuiltInCodeIsPlain) { EXPECT_TRUE(IsPlain()); }

TEST_F(DeliveryStateTest, AnImageIsNeverPlain) {
  struct Imaginary : Object {
    using Object::Object;
    bool HasEntry(uint32_t) const override { return false; }
    bool Dispatch(uint32_t, void*) override { return false; }
  };
  Imaginary image(&system, 7, 0, true);
  EXPECT_FALSE(image.is_plain());
  image.delivery().set_off(false);
  EXPECT_FALSE(image.is_plain());
}

TEST_F(DeliveryStateTest, AnObjectWhoseRobotIsOffIsNotPlain) {
  object.delivery().set_off(true);
  EXPECT_FALSE(IsPlain());
  object.delivery().set_off(false);
  EXPECT_TRUE(IsPlain());
}

TEST_F(DeliveryStateTest, AnObjectThatHasTheProcessorIsNotPlain) {
  object.delivery().set_busy(true);
  EXPECT_FALSE(IsPlain());
  object.delivery().set_busy(false);
  EXPECT_TRUE(IsPlain());
}

TEST_F(DeliveryStateTest, AnObjectWhoseHandlerWaitsIsNotPlain) {
  Fiber fiber;
  object.delivery().set_blocked(&fiber);
  EXPECT_EQ(object.delivery().blocked(), &fiber);
  EXPECT_FALSE(IsPlain());
  object.delivery().set_blocked(nullptr);
  EXPECT_TRUE(IsPlain());
}

TEST_F(DeliveryStateTest, AnObjectIsPlainAgainWhenItsLastHeldMessageIsTaken) {
  OwnedMessage first = NewMessage();
  OwnedMessage second = NewMessage();
  const Message* const newest = second.get();
  object.delivery().Hold(std::move(first));
  object.delivery().Hold(std::move(second));
  EXPECT_FALSE(IsPlain());
  EXPECT_EQ(object.delivery().TakeNewestHeld().get(), newest);
  EXPECT_FALSE(IsPlain());
  object.delivery().TakeNewestHeld();
  EXPECT_TRUE(IsPlain());
}

TEST_F(DeliveryStateTest, AReasonThatEndsHidesNoOtherReason) {
  object.delivery().set_busy(true);
  object.delivery().set_off(true);
  object.delivery().set_busy(false);
  EXPECT_FALSE(IsPlain());
}

// A delivery waits for memory if there are thousands of objects, so this layout saves time.
TEST_F(DeliveryStateTest, WhatEveryDeliveryReadsLiesOnOneCacheLineOfTheObject) {
  const auto* const line = static_cast<const char*>(object.delivery_line());
  EXPECT_EQ(reinterpret_cast<uintptr_t>(line) % 64, 0u);
  EXPECT_EQ(line + 64, reinterpret_cast<const char*>(&object) + sizeof(Object));
}

}  // namespace
}  // namespace openr_host
