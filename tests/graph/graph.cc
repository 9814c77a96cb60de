#include "tests/graph/graph.h"

#include <gtest/gtest.h>

#include <map>

namespace openr_host {

Graph::Graph(const GraphOptions& options)
    : Bench({.stick = options.stick,
             .body = options.body,
             .robot = options.robot,
             .world = options.world,
             .seed = options.seed,
             .measure_stacks = options.measure_stacks}),
      pilot_(&Add<Pilot>("pilot")) {
  Pilot::Wire(&system());
  Boot();
}

std::vector<std::string> Graph::MoverStates() const {
  std::vector<std::string> states;
  const std::string key = "state: ";
  for (size_t at = console().find(key); at != std::string::npos; at = console().find(key, at)) {
    at += key.size();
    states.push_back(console().substr(at, console().find('\n', at) - at));
  }
  return states;
}

bool Graph::RunToStanding() {
  const Object* const mover = system().FindObject(0, "JointMover");
  if (mover == nullptr) return false;
  const auto accepts = [&] { return mover->statistics().state() == "accepting-commands"; };
  if (!system().RunUntil(accepts, 20'000'000)) return false;
  system().RunFor(500'000);
  return true;
}

void WhenStanding(const GraphOptions& options, const std::function<void(Graph&)>& test,
                  openr::testing::Place place) {
  static std::map<std::string, openr::testing::Snapshot<Graph>> standing;
  const auto stand_up = [options] {
    auto graph = std::make_unique<Graph>(options);
    if (!graph->RunToStanding()) {
      ADD_FAILURE() << graph->console() << graph->Findings();
      graph = nullptr;
    }
    return graph;
  };
  const std::string key =
      options.stick + options.robot + options.body + options.world + std::to_string(options.seed);
  standing.try_emplace(key, stand_up).first->second.Run(test, place);
}

}  // namespace openr_host
