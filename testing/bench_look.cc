// The functions of Bench that return the state of the robot and of its objects.
#include <errno.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "openr/decode/decode_message.h"
#include "openr/simulation/standing.h"
#include "runtime/base/spelling.h"
#include "runtime/core/stalls.h"
#include "testing/bench.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {

using openr_host::Finding;
using openr_host::Object;
using openr_host::VirtualRobot;

namespace {

constexpr int kStandingFrames = 75;

// Returns the index in `devices` of the device that has `name` as its name or its locator (the
// OPEN-R path "PRM:/...").  If there is no such device, throws std::invalid_argument.  The text of
// the exception contains `kind`, a word for the devices such as "joint".
template <typename Device>
size_t IndexOf(const std::vector<Device>& devices, std::string_view name, const char* kind) {
  std::vector<std::string> known;
  for (size_t i = 0; i < devices.size(); ++i) {
    if (devices[i].name == name || devices[i].locator == name) return i;
    known.push_back(devices[i].name);
  }
  throw std::invalid_argument(
      fmt::format("no {} '{}'{}", kind, name, openr_host::DidYouMean(name, known)));
}

}  // namespace

// Returns the shell command that runs the present test again with the seed `seed`.
std::string Bench::CommandOf(uint64_t seed) {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string command = fmt::format("OPENR_SEED={} {}", seed, program_invocation_name);
  if (test != nullptr)
    command += fmt::format(" --gtest_filter={}.{}", test->test_suite_name(), test->name());
  return command;
}

std::string Bench::Story() const {
  std::string text = fmt::format("t={:.6f} s.  ", static_cast<double>(now_us()) * 1e-6);
  const std::string last = history_.Text();
  text += last.empty() ? "No message so far.\n" : "Last messages:\n" + last;
  const std::vector<std::string> waits = DescribeWaits(*system_);
  if (!waits.empty()) text += "Who waits:\n";
  for (const std::string& line : waits) text += "  " + line + "\n";
  const std::string held = gate_.Text();
  if (!held.empty()) text += "Behind doors of the test:\n" + held;
  text += "To see it again: " + command_;
  if (history_.last_number() != 0) {
    text +=
        fmt::format("\n  up to the last message: bench.StepToMessage({})", history_.last_number());
  }
  return text + "\n";
}

std::string Bench::Findings() const {
  std::string text;
  for (const Finding& finding : findings()) {
    text +=
        fmt::format("{}: {}: {}{}\n", SeverityName(finding.severity), finding.object, finding.text,
                    openr_host::MessageInParentheses(finding.message, finding.said));
  }
  return text;
}

Object& Bench::object(const std::string& name) const {
  if (Object* const found = system_->FindObject(0, name)) return *found;
  std::vector<std::string> known;
  for (const auto& object : system_->objects()) known.push_back(object->name);
  throw std::invalid_argument(fmt::format("there is no object '{}' on this bench{}", name,
                                          openr_host::DidYouMean(name, known)));
}

const std::string& Bench::state(const std::string& name) const {
  return object(name).statistics().state();
}

VirtualRobot& Bench::dog() const {
  if (dog_ == nullptr)
    throw std::logic_error("this bench has no body: Bench bench({.body = \"ideal\"}), or \"ode\"");
  return *dog_;
}

double Bench::JointDeg(std::string_view name) const {
  const auto& joints = dog().body().state().joints;
  return openr_host::Degrees(joints[IndexOf(model_->joints, name, "joint")].angle_rad);
}

int64_t Bench::SensorValue(std::string_view name) const {
  const std::vector<int> sensors = dog().model().SensorsNamed(name);
  if (sensors.size() == 1) return dog().sensor(sensors[0]).value;
  return dog().sensor(static_cast<int>(IndexOf(model_->sensors, name, "sensor"))).value;
}

int Bench::LedIntensity(std::string_view name) const {
  return dog().devices().leds[IndexOf(model_->leds, name, "LED")].intensity;
}

double Bench::RollDeg() const {
  return openr_host::Degrees(openr_host::RpyOf(dog().body().state().X_WB.linear()).x());
}

double Bench::PitchDeg() const {
  return openr_host::Degrees(openr_host::RpyOf(dog().body().state().X_WB.linear()).y());
}

bool Bench::Standing(Place place) {
  openr_host::StandingMonitor monitor(*model_);
  const openr_host::Body& body = dog().body();
  for (int i = 0; i < kStandingFrames; ++i) {
    Frame(1, place);
    monitor.Sample(body.state(), now_us());
  }
  return monitor.standing();
}

}  // namespace openr::testing
