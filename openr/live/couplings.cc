#include "openr/live/couplings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "openr/live/request_reader.h"
#include "openr/live/run_clock.h"
#include "openr/rewind/rewind.h"

namespace openr_host {
namespace {

constexpr double kRealTime = 1;
constexpr size_t kAddressMax = 255;

}  // namespace

nlohmann::ordered_json Couplings::Answer(uint64_t client, const nlohmann::json& request) {
  const JsonReader reader = RequestReader(request);
  const auto robot = static_cast<int>(reader.WholeOr("robot", 0, INT32_MAX, 0));
  const std::string with = reader.TextOr("with", "");
  std::erase_if(all_,
                [&](const Coupling& each) { return each.client == client && each.robot == robot; });
  const std::string problem = with.empty() ? "" : Begin({client, robot, with});
  Update();
  if (!problem.empty()) return {{"error", problem}};
  return {{"coupled", !with.empty()}, {"rate", clock_->rate()}};
}

// Begins the coupling of a robot of this run with a second robot.  Returns "", or the reason why
// the coupling is refused.
std::string Couplings::Begin(const Coupling& coupling) {
  if (coupling.with.size() > kAddressMax) return "the address is too long";
  if (rewind_->shows_past()) {
    return "a moment of the past is shown, and a second robot cannot go back: go to the present, "
           "or "
           "go on from here, first";
  }
  for (const Coupling& other : all_) {
    if (other.robot != coupling.robot) continue;
    return fmt::format("robot {} is connected to {} by another page or program already",
                       other.robot, other.with);
  }
  all_.push_back(coupling);
  return "";
}

void Couplings::End(uint64_t client) {
  if (std::erase_if(all_, [client](const Coupling& each) { return each.client == client; }) > 0)
    Update();
}

void Couplings::Forget() {
  all_.clear();
  is_paced_ = false;
  rewind_->Refuse("");
}

void Couplings::Update() {
  rewind_->Refuse(
      all_.empty()
          ? ""
          : fmt::format("the robot at {} is connected, and cannot go back with it", all_[0].with));
  // Changes the rate of the run (its speed) only when the first coupling begins or the last
  // coupling ends, and never if the run must keep the rate it began with.
  if (all_.empty() == !is_paced_ || clock_->is_fixed()) return;
  is_paced_ = !all_.empty();
  if (is_paced_) {
    rate_before_ = clock_->rate();
    clock_->set_rate(kRealTime);
  } else if (clock_->rate() == kRealTime) {
    clock_->set_rate(rate_before_);
  }
}

}  // namespace openr_host
