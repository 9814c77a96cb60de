// Tests of the second stack of an object: switches to it and back, and the data on it.
#include "runtime/api/second_stack.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

class SecondStackTest : public ::testing::Test {
 protected:
  SecondStackTest()
      : object(*system.AddObject<CodeObject>(0, "Looper")), scope(&system, &object.host()) {}
  ~SecondStackTest() override { openr_second_stack_delete(stack); }

  void Run(std::function<void()> what) {
    body = std::move(what);
    openr_second_stack_run(
        stack, [](void* self) { static_cast<SecondStackTest*>(self)->body(); }, this);
  }
  void Leave() { openr_second_stack_leave(stack); }
  void Continue() { openr_second_stack_continue(stack); }

  System system;
  CodeObject& object;
  CurrentScope scope;
  OpenrSecondStack* stack = openr_second_stack_new();
  std::function<void()> body;
  std::string said;
};

TEST_F(SecondStackTest, ABodyThatEndsReturnsToWhoRanIt) {
  Run([this] { said += "body "; });
  said += "after";
  EXPECT_EQ(said, "body after");
}

TEST_F(SecondStackTest, ALoopGoesOnWhereItLeft) {
  Run([this] {
    for (int i = 1; i <= 3; ++i) {
      said += std::to_string(i);
      Leave();
    }
    said += "end";
  });
  for (int i = 0; i < 3; ++i) {
    said += ".";
    Continue();
  }
  EXPECT_EQ(said, "1.2.3.end");
}

TEST_F(SecondStackTest, ItIsContinuedFromAnyDepthOfTheOtherStack) {
  Run([this] {
    for (;;) Leave();
  });
  const std::function<void(int)> deep = [&](int levels) {
    [[maybe_unused]] const volatile char room[256] = {};
    if (levels > 0) return deep(levels - 1);
    Continue();
    said += "back";
  };
  for (const int levels : {1, 50, 5}) deep(levels);
  EXPECT_EQ(said, "backbackback");
}

TEST_F(SecondStackTest, ExceptionsBelongToTheirStack) {
  Run([this] {
    try {
      throw std::runtime_error("there");
    } catch (const std::exception& error) {
      Leave();
      said += error.what();
      try {
        throw;
      } catch (const std::runtime_error&) {
        said += " again";
      }
    }
  });
  EXPECT_EQ(std::current_exception(), nullptr);
  try {
    throw std::logic_error("here");
  } catch (const std::exception& error) {
    Continue();
    said += std::string(" ") + error.what();
  }
  EXPECT_EQ(said, "there again here");
}

TEST_F(SecondStackTest, ABodyThatNeverEndsCanBeReplacedAndDeleted) {
  for (int i = 0; i < 3; ++i) {
    Run([this] {
      const std::string kept(100, 'x');
      for (;;) {
        said += kept[0];
        Leave();
      }
    });
    Continue();
  }
  EXPECT_EQ(said, "xxxxxx");
}

TEST_F(SecondStackTest, AFindingIsAWarningAboutTheRunningObject) {
  openr_finding("look");
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_EQ(system.findings().all()[0].object, "Looper");
  EXPECT_EQ(system.findings().all()[0].text, "look");
  EXPECT_FALSE(system.findings().HasError());
}

}  // namespace
}  // namespace openr_host
