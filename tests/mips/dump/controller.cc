// Controller's logic, through the functions a controller calls.
#include <device/distance_sensor.h>
#include <device/led.h>
#include <device/mtn.h>
#include <device/robot.h>
#include <device/servo.h>
#include <device/touch_sensor.h>
#include <string.h>

#include "ControllerApi.h"
#include "ControllerCore.h"
#include "dump.h"

namespace {

class Robot : public ControllerPort {
 public:
  Robot() : core(this), draw(11) {
    core.Begin(FindRobot("ERS-210"));
    SetControllerCore(&core);
  }
  virtual ~Robot() { SetControllerCore(0); }
  virtual bool IsLedReady() { return true; }
  virtual bool IsEarReady() { return draw.Next() % 2 == 0; }
  virtual bool IsBatchMoverReady() { return draw.Next() % 3 != 0; }
  virtual void SendLeds(Uint32 on, int frames) { printf("leds %08x for %d\n", on, frames); }
  virtual void SendEars(Uint32 on) { printf("ears %x\n", on); }
  virtual void SendBatch(const BatchMoverCommand& batch) {
    PrintBytes("batch", reinterpret_cast<const Uint8*>(&batch), sizeof(batch));
  }
  virtual void SendMover(const MoverCommand& command) {
    PrintBytes("mover", reinterpret_cast<const Uint8*>(&command), sizeof(command));
  }
  virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string*) {
    printf("read %s\n", path.c_str());
    *bytes = MakeMotion(3, 5, &draw);
    return true;
  }
  virtual int BatteryCapacity() { return 87; }
  virtual void TimeStepRounded(int askedMs, int usedMs) {
    printf("rounded %d to %d\n", askedMs, usedMs);
  }

  // A controller that loops: there is one stack, as on the robot.
  virtual void UnknownDevice(const char* locator) { printf("unknown %s\n", locator); }
  virtual void Remark(const char* text) { printf("remark %s\n", text); }
  virtual void Print(const char* text) { printf("print %s\n", text); }
  virtual void RunLoop(void (*body)(void*), void* argument) { body(argument); }
  virtual bool SuspendLoop() { return false; }
  virtual void ContinueLoop() {}
  virtual void EndLoop() {}
  virtual void EnableCamera(bool) {}

  ControllerCore core;
  Draw draw;
};

Robot* robot_now = 0;

DeviceTag Device(int tag) { return static_cast<DeviceTag>(tag); }

// Values of float are printed as whole millionths: their text is the C library's business.
int RunOnce(int) {
  Draw& draw = robot_now->draw;
  for (int i = 0; i < 6; i++) {
    const DeviceTag tag = Device(draw.Between(0, 60));
    const float value = static_cast<float>(draw.Between(-4000000, 4000000)) / 1000000.0f;
    switch (draw.Next() % 6) {
      case 0:
        servo_set_position(tag, value);
        break;
      case 1:
        servo_set_velocity(tag, value);
        break;
      case 2:
        servo_set_acceleration(tag, value * 10);
        break;
      case 3:
        servo_motor_off(tag);
        break;
      case 4:
        led_set(tag, static_cast<unsigned char>(draw.Next() % 2));
        break;
      default:
        printf("read %d %d %d\n", static_cast<int>(servo_get_position(tag) * 1000000.0f),
               static_cast<int>(distance_sensor_get_value(tag)),
               static_cast<int>(touch_sensor_get_value(tag)));
    }
  }
  return draw.Between(1, 200);
}

int Main() {
  robot_run(RunOnce);
  return 0;
}

}  // namespace

void DumpController() {
  Robot robot;
  robot_now = &robot;
  robot.core.Execute(Main);
  for (int round = 0; round < 400; round++) {
    SensorValues values;
    memset(&values, 0, sizeof(values));
    for (int j = 0; j < MAX_JOINTS; j++) values.joint[j] = robot.draw.Between(-2000000, 2000000);
    for (int i = 0; i < MAX_SENSORS; i++) values.sensor[i] = robot.draw.Between(0, 980665);
    robot.core.SetSensors(values);
    if (round % 7 == 3) {
      LedEarState change;
      memset(&change, 0, sizeof(change));
      change.ledMask = robot.draw.Next() & 0x1ff;
      change.ledOn = robot.draw.Next() & change.ledMask;
      robot.core.RemoteLights(change);
    }
    robot.core.LedReady();
  }
  MTN* motion = mtn_new("walk.mtn");
  if (motion != 0) {
    printf("motion of %d ms\n", static_cast<int>(mtn_get_length(motion)));
    mtn_play(motion);
    mtn_delete(motion);
  }
  robot_now = 0;
}
