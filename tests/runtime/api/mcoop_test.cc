// Tests of the functions of MCOOP.h with SystemCalls of the test.
#include <MCOOP.h>
#include <gtest/gtest.h>

#include <memory>

#include "runtime/core/api.h"
#include "runtime/core/code_object.h"
#include "runtime/core/local_calls.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// SystemCalls that note calls which take memory of the object's heap, because they are made as code
// of the object's image.
class NotingCalls : public LocalCalls {
 public:
  using LocalCalls::LocalCalls;
  void SetQueueMax(int32_t messages) override {
    Note();
    LocalCalls::SetQueueMax(messages);
  }
  bool ResizeRegion(uint32_t region, size_t size) override {
    Note();
    return LocalCalls::ResizeRegion(region, size);
  }
  int count = 0;
  int count_as_image = 0;

 private:
  void Note() {
    ++count;
    if (t_current.image_code) ++count_as_image;
  }
};

TEST(McoopTest, NoCallOfAProgramTakesMemoryOfItsObjectForTheRuntime) {
  NotingCalls* calls = nullptr;
  SystemOptions options;
  options.make_calls = [&calls](System* system) {
    auto made = std::make_unique<NotingCalls>(system);
    calls = made.get();
    return made;
  };
  System system(options);
  Object* const object = &system.AddObject<CodeObject>(0, "caller")->host();
  const uint32_t region = system.regions().New(100, object->id);
  sError shrunk = sFAIL, grown = sFAIL, set = sFAIL;
  {
    const CurrentScope scope(&system, object, true);
    shrunk = ShrinkMemoryRegion(region, 50);
    grown = GrowMemoryRegion(region, 100);
    set = SetResourceValue(rMAXQUEUESIZE, 40);
  }
  EXPECT_EQ(shrunk, sSUCCESS);
  EXPECT_EQ(grown, sSUCCESS);
  EXPECT_EQ(set, sSUCCESS);
  EXPECT_EQ(calls->count, 3);
  EXPECT_EQ(calls->count_as_image, 0);
}

// An object with an entry to which others send requests.
class Asked : public CodeObject {
 public:
  Asked() {
    AddExtra("Question", [](void*) { Reply(); });
  }
};

TEST(McoopTest, NoCallWaitsForAnAnswerInAConstructor) {
  System system;
  const ObjectId asked = system.AddObject<Asked>(0, "asked")->host().id;
  Object* const object = &system.AddObject<CodeObject>(0, "caller")->host();
  const CurrentScope scope(&system, object);
  const OID oid = OidOf(asked);
  char question[] = "?";
  EXPECT_EQ(Call(oid, oentryBASE, question, sizeof question), sFAIL);
  RID box;
  ASSERT_EQ(SendWithRBox(oid, oentryBASE, question, sizeof question, &box), sSUCCESS);
  size_t got = 0;
  EXPECT_EQ(Receive(box, question, sizeof question, &got, nullptr), sFAIL);
  ASSERT_EQ(system.findings().all().size(), 2u);
  EXPECT_EQ(system.findings().all()[0].text,
            "Call() in a constructor or destructor fails: only a handler can wait for an answer; "
            "do it in DoInit or DoDestroy");
  EXPECT_EQ(system.findings().all()[1].text,
            "Receive() in a constructor or destructor fails: only a handler can wait for an "
            "answer; do it in DoInit or DoDestroy");
}

TEST(McoopTest, AProgramThatWaitsBetweenCallsOfGetSystemTimeIsNoBusyLoop) {
  System system;
  Object* const object = &system.AddObject<CodeObject>(0, "waiter")->host();
  const CurrentScope scope(&system, object);
  SystemTime time;
  // 999 waits of 1 ms and 1000 calls, each of which takes 1 us.
  GetSystemTime(&time);
  for (int i = 0; i < 999; ++i) {
    Wait(1'000'000);
    GetSystemTime(&time);
  }
  EXPECT_EQ(time.seconds, 1u);
  EXPECT_EQ(time.useconds, 0u);
  EXPECT_TRUE(system.findings().all().empty());
}

TEST(McoopTest, AWaitHidesNoBusyLoopOnGetSystemTime) {
  System system;
  Object* const object = &system.AddObject<CodeObject>(0, "waiter")->host();
  const CurrentScope scope(&system, object);
  Wait(2'000'000'000);
  SystemTime time;
  for (int i = 0; i < 1'000'000; ++i) GetSystemTime(&time);
  EXPECT_EQ(time.seconds, 3u);
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("1000000 calls of GetSystemTime()"),
            std::string::npos);
}

}  // namespace
}  // namespace openr_host
