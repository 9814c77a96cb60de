// Tests of the functions of MCOOP.h with SystemCalls of the test.
#include <MCOOP.h>
#include <gtest/gtest.h>

#include <memory>

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

}  // namespace
}  // namespace openr_host
