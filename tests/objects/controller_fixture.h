// A robot that remembers what a controller told it.
#pragma once

#include <device/robot.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ControllerApi.h"
#include "ControllerCore.h"
#include "loop_stack_of_test.h"
#include "mtn_bytes.h"

namespace openr_host {

inline constexpr const char* kTilt = "PRM:/r1/c1-Joint2:j1";
inline constexpr const char* kLeftEar = "PRM:/r1/c1/c2/c3/e1-Joint3:j5";
inline constexpr const char* kEye = "PRM:/r1/c1/c2/c3/l2-LED2:l2";
inline constexpr const char* kPsd = "PRM:/r1/c1/c2/c3/p1-Sensor:p1";
inline constexpr const char* kPaw = "PRM:/r2/c1/c2/c3/c4-Sensor:s4";
inline constexpr const char* kHead = "PRM:/r1/c1/c2/c3/f2-Sensor:f2";
inline constexpr const char* kThermo = "PRM:/r6/t1-Sensor:t1";

// Functions that the test's controller calls; plain functions, as the interface takes no others.
inline std::function<void()> g_main;
inline std::function<int()> g_run;
inline int g_reset_count, g_die_count;
inline std::vector<int> g_arguments;

inline int Main() {
  if (g_main) g_main();
  return 0;
}
inline int RunOnce(int k) {
  g_arguments.push_back(k);
  return g_run ? g_run() : 64;
}
inline void Reset() { ++g_reset_count; }
inline void Die() { ++g_die_count; }

class ControllerTest : public testing::Test, public ControllerPort {
 protected:
  ControllerTest() : core(this), robot(FindRobot("ERS-210")) {
    g_main = [] { robot_run(RunOnce); };
    g_run = nullptr;
    g_reset_count = g_die_count = 0;
    g_arguments.clear();
    core.Begin(robot);
    SetControllerCore(&core);
  }
  ~ControllerTest() override { SetControllerCore(nullptr); }

  bool IsLedReady() override { return led_ready; }
  bool IsEarReady() override { return ear_ready; }
  bool IsBatchMoverReady() override { return batch_ready; }
  void SendLeds(Uint32 on, int frames) override {
    leds.push_back(on);
    led_frames.push_back(frames);
  }
  void SendEars(Uint32 on) override { ears.push_back(on); }
  void SendBatch(const BatchMoverCommand& batch) override { batches.push_back(batch); }
  void SendMover(const MoverCommand& command) override { movers.push_back(command); }
  bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) override {
    if (!files.contains(path)) {
      *error = path + ": no such file on the Memory Stick";
      return false;
    }
    *bytes = files[path];
    return true;
  }
  int BatteryCapacity() override { return 87; }
  void EnableCamera(bool on) override { camera_on = on; }
  void TimeStepRounded(int asked_ms, int used_ms) override {
    rounded.push_back({asked_ms, used_ms});
  }
  void UnknownDevice(const char* locator) override { unknown.emplace_back(locator); }
  void Remark(const char* text) override { remarks.emplace_back(text); }
  void Print(const char* text) override { printed += text; }
  void RunLoop(void (*body)(void*), void* argument) override {
    has_loop_stack ? loop_stack.Run(body, argument) : body(argument);
  }
  bool SuspendLoop() override { return has_loop_stack && loop_stack.Leave(); }
  void ContinueLoop() override { loop_stack.Continue(); }
  void EndLoop() override { throw MethodEnds(); }

  // exit() of the robot ends the method that calls it and nothing else.
  struct MethodEnds {};
  static void CallMethod(const std::function<void()>& method) {
    try {
      method();
    } catch (const MethodEnds&) {
    }
  }

  // Runs the control loop for `iterations` ready events with `body` as the run function.
  void Loop(int iterations, std::function<void()> body, int step_ms = 64) {
    g_run = [=] {
      if (body) body();
      return step_ms;
    };
    core.Execute(Main);
    for (int i = 1; i < iterations; ++i) core.LedReady();
  }
  const BatchJoint& Joint(const char* locator) {
    return batches.back().joint[FindJoint(robot, locator)];
  }
  void AddMotion(const std::string& name, const MtnBytes& mtn) {
    files["/MS/OPEN-R/MW/DATA/P/" + name] = mtn.Bytes();
  }
  void Tell(const char* file, int state, int key_frame, bool over = false) {
    SetValueMessage message = {};
    message.state = state;
    message.keyFrame = key_frame;
    message.isOver = over ? 1 : 0;
    std::strcpy(message.file, file);
    SetMotionValues(message);
  }
  void Sense(const char* locator, int32_t value) {
    const int joint = FindJoint(robot, locator);
    if (joint >= 0) {
      values.joint[joint] = value;
    } else {
      values.sensor[FindSensor(robot, locator)] = value;
    }
    core.SetSensors(values);
  }

  ControllerCore core;
  const RobotConstants* robot;
  SensorValues values = {};
  bool led_ready = true, ear_ready = true, batch_ready = true;
  std::vector<uint32_t> leds, ears;
  std::vector<int> led_frames;
  std::vector<BatchMoverCommand> batches;
  std::vector<MoverCommand> movers;
  std::vector<std::pair<int, int>> rounded;
  std::map<std::string, std::vector<uint8_t>> files;
  std::vector<std::string> remarks, unknown;
  std::string printed;
  bool camera_on = false;
  bool has_loop_stack = true;  // the host's; the robot has none
  LoopStackOfTest loop_stack;
};

}  // namespace openr_host
