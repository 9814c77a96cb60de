// Rows that compare a run of the full graph, which is all objects of a dog, with its simulated body
// alone.  One operation is one frame of 8 ms.
#include <memory>

#include "bench/bench.h"
#include "bench/dogs.h"

namespace openr_host {

std::vector<Row> GraphRows(const std::string& stick) {
  const auto bare = [stick] { return std::make_unique<BareBodies>(stick, 1); };
  const auto reference = [stick] { return std::make_unique<OdeWorlds>(stick, 1); };
  const auto graph = [stick](const char* body) {
    return [stick, body] { return std::make_unique<Dogs>(OfDogs(stick, body, 1)); };
  };
  Row body{"body of a standing dog; a frame", "ns a frame", 250};
  // The limit is 1.3 times a step of MuJoCo, measured beside a step of ODE.
  body.variants = {
      Lazily<OdeWorlds>("ODE's exact solver", reference),
      Lazily<BareBodies>("bare ODE body", bare, {{Limit::Kind::kRatioAtMost, 35.0 / 185}})};

  Row full{"full graph, sensors, trace hash; a frame", "ns a frame", 250};
  full.variants = {
      Lazily<BareBodies>("bare ODE body", bare),
      Lazily<Dogs>("full graph on it", graph("ode"), {{Limit::Kind::kMoreThanFloor, 3000}})};

  Row ideal{"full graph on the ideal body; a frame", "ns a frame", 2500};
  ideal.variants = {Lazily<Dogs>("full graph", graph("ideal"), {{Limit::Kind::kTime, 2700}})};
  ideal.note = "2.67 us are 3,000 times real time";

  std::vector<Row> rows = {body, full, ideal};
  for (Row& row : rows) row.warm_up = row.count / 10;
  return rows;
}

}  // namespace openr_host
