// Probe objects: a subject and an observer that record every call.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {

class SubjectProbe : public CodeObject {
 public:
  explicit SubjectProbe(const std::string& service = "Sender.Out.Number.S") {
    out = AddSubject(service, [this](const OReadyEvent& event) {
      readies.push_back(event.IsAssert() ? fmt::format("ready:{}", out->IsReady()) : "deassert");
      if (on_ready) on_ready(event);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    if (on_start) on_start();
    return oSUCCESS;
  }

  // Sends one number to the observers.
  OStatus Send(int value) {
    out->SetData(&value, sizeof value);
    return out->NotifyObservers();
  }

  OSubject* out;
  std::vector<std::string> readies;
  std::function<void(const OReadyEvent&)> on_ready;
  std::function<void()> on_start;
};

class ObserverProbe : public CodeObject {
 public:
  explicit ObserverProbe(const std::string& service = "Receiver.In.Number.O") {
    in = AddObserver(service, [this](const ONotifyEvent& event) {
      std::string text;
      for (int i = 0; i < event.NumOfData(); ++i) {
        int value = 0;
        std::memcpy(&value, event.Data(i), sizeof value);
        text += fmt::format("{}{}", i == 0 ? "" : ",", value);
      }
      events.push_back(text);
      notify_counts.push_back(event.NumOfNotify());
      if (on_notify) on_notify(event);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    if (on_start) on_start();
    return oSUCCESS;
  }

  OObserver* in;
  std::vector<std::string> events;  // "1,2": the numbers of each event
  std::vector<int> notify_counts;
  std::function<void(const ONotifyEvent&)> on_notify;
  std::function<void()> on_start;
};

// Runs code at once, as a handler of `object`.
inline void RunAs(CodeObject* object, const std::function<void()>& body) {
  const CurrentScope scope(&object->system(), &object->host());
  body();
}

// A sender whose subject is connected with two observers, in a system that has started.
class TwoObserversTest : public testing::Test {
 protected:
  TwoObserversTest() {
    system.AddRobot("ERS-210", nullptr);
    sender = system.AddObject<SubjectProbe>(0, "sender");
    first = system.AddObject<ObserverProbe>(0, "first", "First.In.Number.O");
    second = system.AddObject<ObserverProbe>(0, "second", "Second.In.Number.O");
    system.Connect({0, "Sender.Out.Number.S", "First.In.Number.O", "test"});
    system.Connect({0, "Sender.Out.Number.S", "Second.In.Number.O", "test"});
    system.Boot();
    Settle();
  }
  void Settle() { system.RunFor(1000); }

  System system;
  SubjectProbe* sender;
  ObserverProbe* first;
  ObserverProbe* second;
};

}  // namespace openr_host
