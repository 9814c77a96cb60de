// The dog on its ODE body with one of the example controllers.
#pragma once

#include <OPENR/ODataFormats.h>
#include <openr/testing.h>

#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "tests/graph/pilot.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

inline constexpr char kDistance[] = "PRM:/r1/c1/c2/c3/p1-Sensor:p1";

// A world with a wall across the dog's way, its near side `distance_m` ahead of where it begins.
inline std::string WorldWithWall(double distance_m) {
  static const TempFolder folder;
  const std::string name = folder.path() + "/wall.json";
  std::ofstream(name) << R"({"schema": "openr-host world 1", "name": "wall", "boxes": [)"
                      << R"({"name": "wall", "size_m": [0.1, 1.2, 0.6], "centre_m": [)"
                      << distance_m + 0.05 << ", 0, 0.3]}]}";
  return name;
}

class ControlledDog : public openr::testing::Bench {
 public:
  // `controller`: "WALK.BIN".
  explicit ControlledDog(const std::string& controller, const std::string& world = "")
      : Bench({.stick = OPENR_STICK,
               .replace = {openr::testing::StandIn("Controller",
                                                   [controller](openr::testing::Bench& bench) {
                                                     bench.AddImage(std::string(OPENR_IMAGES) +
                                                                    "/" + controller);
                                                   })},
               .body = "ode",
               .world = world}) {
    pilot_ = &Add<Pilot>("pilot");
    Pilot::Wire(&system());
    OnMessage([this](const openr::testing::SeenMessage& message) { Feel(message); });
    Boot();
  }

  // Until JointMover takes commands: that is when the controller begins.
  bool StandUp() {
    return RunUntil([this] { return state("JointMover") == "accepting-commands"; },
                    std::chrono::seconds(20));
  }

  // Seconds of virtual time.
  void Run(double seconds) {
    RunFor(std::chrono::microseconds(static_cast<int64_t>(seconds * 1e6)));
  }

  // Somebody touches the dog: from now on the sensor reads this for the controller.
  void Touch(const std::string& locator, int32_t value) { touched_[locator] = value; }
  void LetGo(const std::string& locator) { touched_.erase(locator); }

  // Commands joints as the remote control does.
  Pilot& pilot() { return *pilot_; }

  Eigen::Vector3d Place() const { return dog().body().state().X_WB.translation(); }
  bool Light(const std::string& name) const { return LedIntensity(name) != 0; }

 private:
  void Feel(const openr::testing::SeenMessage& message) {
    if (touched_.empty() || !message.to().service.starts_with("Controller.Sensor.") ||
        message.kind() != openr::testing::MessageKind::kNotify)
      return;
    for (int i = 0; i < message.data_count(); ++i) {
      // The body has no hands to touch it with; what it sent is changed on the way.
      auto* const vector =
          reinterpret_cast<OSensorFrameVectorData*>(const_cast<char*>(message.data(i).data()));
      for (const auto& [locator, value] : touched_) {
        OSensorFrameData* const data = vector->GetData(Element(locator));
        for (auto& frame : data->frame) frame.value = value;
      }
    }
  }

  int Element(const std::string& locator) const {
    for (size_t i = 0; i < model().sensors.size(); ++i) {
      if (model().sensors[i].locator == locator) return static_cast<int>(i);
    }
    throw std::invalid_argument("no sensor " + locator);
  }

  Pilot* pilot_ = nullptr;
  std::map<std::string, int32_t> touched_;
};

}  // namespace openr_host
