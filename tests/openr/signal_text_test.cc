#include "openr/ending/signal_text.h"

#include <OPENR/ObjcommMessages.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/core/code_object.h"
#include "runtime/core/current.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

std::string JsonOf(const SignalText& record, const SignalText& finding) {
  int ends[2];
  EXPECT_EQ(pipe(ends), 0);
  WriteEndingAsJson(record, finding, "crash", Current{}, ends[1]);
  close(ends[1]);
  char buffer[8192];
  const ssize_t size = read(ends[0], buffer, sizeof buffer);
  close(ends[0]);
  return {buffer, static_cast<size_t>(size)};
}

std::string ErrorOf(const SignalText& text) {
  return nlohmann::json::parse(JsonOf(text, text))["error"].get<std::string>();
}

TEST(SignalTextTest, AsJsonItSaysTheSameWithoutTheLastLineEnd) {
  SignalText text;
  text.Add("OBJECT \"a\\b\", message ").AddNumber(12).Add("\nSTACK\n");
  EXPECT_EQ(ErrorOf(text), "OBJECT \"a\\b\", message 12\nSTACK");
  EXPECT_EQ(JsonOf(text, text).back(), '\n');
}

TEST(SignalTextTest, WhatDoesNotFitIsLeftOutAndTheObjectIsClosedAllTheSame) {
  SignalText text;
  for (int i = 0; i < 2000; ++i) text.Add("\"");
  const std::string error = ErrorOf(text);
  EXPECT_GT(error.size(), 400u);
  EXPECT_EQ(error, std::string(error.size(), '"'));
}

TEST(SignalTextTest, TheFindingIsThatOfAReport) {
  SignalText finding;
  finding.Add("crash");
  const nlohmann::json found = nlohmann::json::parse(JsonOf({}, finding))["findings"].at(0);
  EXPECT_EQ(found["severity"], "error");
  EXPECT_EQ(found["text"], "crash");
  EXPECT_EQ(found["time_s"], 0.0);
}

class Receiver : public CodeObject {};

// A message that an object handles.
class CurrentMessageTest : public testing::Test {
 protected:
  CurrentMessageTest() {
    const int robot = system_.AddRobot("ERS-210", nullptr);
    sender_ = &system_.AddObject<Receiver>(robot, "Sender")->host();
    receiver_ = &system_.AddObject<Receiver>(robot, "Receiver")->host();
    receiver_->BeginHandler(system_.queue().Allocate().release());
    message().sender = sender_->id;
  }
  ~CurrentMessageTest() override { receiver_->EndHandler(); }

  Message& message() const { return *receiver_->running(); }

  // Returns the line about the message.  `image_code` is true if a signal has interrupted code of
  // the object.
  std::string Line(bool image_code = true) {
    SignalText text;
    {
      const CurrentScope scope(&system_, receiver_, image_code);
      AddCurrentMessage(&text);
    }
    return std::string(text.text());
  }

  System system_;
  Object* sender_ = nullptr;
  Object* receiver_ = nullptr;
};

TEST_F(CurrentMessageTest, EachKindIsNamed) {
  message().size = 1;
  EXPECT_EQ(Line(), "MESSAGE from Sender, 1 byte\n");
  message().kind = PayloadKind::kHashed;
  message().size = 40;
  EXPECT_EQ(Line(), "MESSAGE request or answer of the network stack from Sender, 40 bytes\n");
  message().kind = PayloadKind::kReady;
  auto& ready = *new (message().payload) OReadyMessage();
  ready.command = objcommCMD_ASSERT_READY;
  EXPECT_EQ(Line(), "MESSAGE ready (assert) from Sender, 40 bytes\n");
  ready.command = objcommCMD_DEASSERT_READY;
  EXPECT_EQ(Line(), "MESSAGE not ready (deassert) from Sender, 40 bytes\n");
}

TEST_F(CurrentMessageTest, TheBytesOfANotificationAreThoseOfItsRegions) {
  message().kind = PayloadKind::kNotify;
  auto& notify = *new (message().payload) ONotifyMessage();
  notify.numOfData = 2;
  notify.data[0].size = 80;
  notify.data[1].size = 4;
  EXPECT_EQ(Line(), "MESSAGE notification from Sender, 84 bytes\n");
  notify.numOfData = -1;  // damaged
  EXPECT_EQ(Line(), "MESSAGE notification from Sender, 0 bytes\n");
  for (auto& data : notify.data) data.size = 1;
  notify.numOfData = 30'000;
  EXPECT_EQ(Line(), fmt::format("MESSAGE notification from Sender, {} bytes\n", MAX_NUM_DATA));
}

// The runtime may be changing its table of objects when the signal comes.
TEST_F(CurrentMessageTest, TheSenderIsLeftOutWhileTheRuntimeRuns) {
  message().size = 8;
  EXPECT_EQ(Line(false), "MESSAGE, 8 bytes\n");
  message().sender = kNoObject;
  EXPECT_EQ(Line(), "MESSAGE, 8 bytes\n");
}

TEST_F(CurrentMessageTest, WithoutAMessageThereIsNoLine) {
  receiver_->EndHandler();
  EXPECT_EQ(Line(), "");
}

}  // namespace
}  // namespace openr_host
