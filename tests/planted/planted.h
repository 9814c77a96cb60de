// Small graphs with a fault in each, and how it is looked for.
//
// Every test says what catches the fault: a finding, a property, or a property under another
// order.  Those of orders also say that the default order misses it.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "openr/explore/explorer.h"
#include "runtime/core/code_object.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"

namespace openr_host {

using Json = nlohmann::ordered_json;

// An object that says what it is doing and can wake itself.
class Actor : public CodeObject {
 protected:
  // As OSYSLOG1((osyslogINFO, "state: ...")) does.
  void Say(const std::string& state) { host().statistics().set_state(state); }
  void Post(ObjectId target, Selector entry, int64_t delay_us = 0) {
    system().Post(system().NewMessage(target, entry), delay_us);
  }
  static void Send(OSubject* subject, int value) {
    subject->SetData(&value, sizeof value);
    subject->NotifyObservers();
  }
  static int NumberIn(const ONotifyEvent& event) {
    int value = 0;
    std::memcpy(&value, event.Data(0), sizeof value);
    return value;
  }
};

// A graph of code objects that `build` puts into a system with one robot.
template <typename Build>
PrepareRun SceneOf(Build build, SystemOptions options = {}) {
  options.console = [](std::string_view) {};
  return [build, options] {
    const auto system = std::make_shared<System>(options);
    system->AddRobot("ERS-210", nullptr);
    build(system.get());
    PreparedRun prepared;
    prepared.system = system.get();
    prepared.owner = system;
    return prepared;
  };
}

inline void Wire(System* system, const std::string& subject, const std::string& observer) {
  system->Connect({0, subject, observer, "planted"});
}

// Runs of 3 s, long enough for whoever waits to have waited for too long.
inline ExplorePlan PlanOf(PrepareRun prepare_run,
                          std::vector<std::string> properties = {"default"}) {
  ExplorePlan plan;
  plan.prepare_run = std::move(prepare_run);
  plan.run.for_us = 3'000'000;
  plan.run.properties.names = std::move(properties);
  plan.limits.handler_us = 300'000;
  plan.runs = 100;
  return plan;
}

// The property that broke, and the number of deviations; "" if no property broke.
struct Broken {
  std::string property;
  std::string text;
  size_t deviations = 0;
  uint64_t runs = 0;
  Json failure;
};

inline Broken BrokenIn(const Json& result) {
  Broken broken;
  broken.runs = result["runs"].get<uint64_t>();
  if (!result.contains("failure")) return broken;
  broken.failure = result["failure"];
  broken.property = broken.failure["property"].get<std::string>();
  broken.text = broken.failure["text"].get<std::string>();
  broken.deviations = broken.failure["deviations"].size();
  return broken;
}

// The canonical order alone.
inline Broken InDefaultOrder(ExplorePlan plan) {
  plan.runs = 1;
  return BrokenIn(ExploreSeeds(plan));
}

inline Broken InRandomOrders(const ExplorePlan& plan) { return BrokenIn(ExploreSeeds(plan)); }

inline Broken InAllOrders(ExplorePlan plan) {
  plan.runs = 10'000;
  return BrokenIn(SearchOrders(plan));
}

}  // namespace openr_host
