#include "ControllerApi.h"

#include <stdarg.h>
#include <stdio.h>

#include <device/accelerometer.h>
#include <device/distance_sensor.h>
#include <device/led.h>
#include <device/robot.h>
#include <device/servo.h>
#include <device/thermometer.h>
#include <device/touch_sensor.h>

static ControllerCore* theCore = 0;

void
SetControllerCore(ControllerCore* core)
{
    theCore = core;
}

ControllerCore*
GetControllerCore()
{
    return theCore;
}

// ---- robot.h -------------------------------------------------------------------------

void
robot_live(void (*reset)(void))
{
    if (theCore != 0) theCore->Live(reset);
}

void
robot_die(void (*die)(void))
{
    if (theCore != 0) theCore->OnDie(die);
}

void
robot_run(int (*run)(int))
{
    if (theCore != 0) theCore->Run(run);
}

int
robot_step(int ms)
{
    return theCore != 0 ? theCore->Step(ms) : 0;
}

DeviceTag
robot_get_device(const char* name)
{
    return theCore != 0 ? (DeviceTag)theCore->FindDevice(name) : 0;
}

int
robot_has_device(const char* name)
{
    return theCore != 0 && theCore->Devices().Find(name) != 0;
}

int
robot_get_mode(void)
{
    return 1;
}

void
robot_battery_sensor_enable(unsigned short)
{
}

void
robot_battery_sensor_disable(void)
{
}

float
robot_battery_sensor_get_value(void)
{
    return theCore != 0 ? (float)theCore->Port()->BatteryCapacity() : 0.0f;
}

void
robot_console_printf(const char* format, ...)
{
    char text[240];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof(text), format, arguments);
    va_end(arguments);
    text[sizeof(text) - 1] = '\0';
    if (theCore != 0) theCore->Port()->Print(text);
}

// ---- led.h ---------------------------------------------------------------------------

void
led_set(DeviceTag tag, unsigned char value)
{
    if (theCore == 0) return;
    const int led = theCore->Devices().Led(tag);
    if (led >= 0) theCore->SetLed(led, value != 0);
}

// ---- servo.h -------------------------------------------------------------------------

// Returns the index in RobotConstants::joints of the joint to which the device tag `tag` belongs;
// -1 if `tag` belongs to no joint.
static int
JointOf(DeviceTag tag)
{
    return theCore != 0 ? theCore->Devices().Joint(tag) : -1;
}

void
servo_enable_position(DeviceTag, unsigned short)
{
}

void
servo_disable_position(DeviceTag)
{
}

float
servo_get_position(DeviceTag tag)
{
    const int joint = JointOf(tag);
    return joint >= 0 ? (float)(theCore->Sensors().joint[joint] * 1e-6) : 0.0f;
}

void
servo_set_position(DeviceTag tag, float position)
{
    const int joint = JointOf(tag);
    if (joint >= 0) {
        theCore->SetPosition(joint, position);
        return;
    }
    const int ear = theCore != 0 ? theCore->Devices().Ear(tag) : -1;
    if (ear >= 0) theCore->SetEar(ear, position == 0.0f);
}

void
servo_set_velocity(DeviceTag tag, float velocity)
{
    const int joint = JointOf(tag);
    if (joint >= 0) theCore->SetVelocity(joint, velocity);
}

void
servo_set_acceleration(DeviceTag tag, float acceleration)
{
    const int joint = JointOf(tag);
    if (joint >= 0) theCore->SetAcceleration(joint, acceleration);
}

void
servo_set_force(DeviceTag, float)
{
}

void
servo_motor_off(DeviceTag tag)
{
    const int joint = JointOf(tag);
    if (joint >= 0) theCore->MotorOff(joint);
}

// ---- Sensors -------------------------------------------------------------------------

static const SensorConstants*
SensorOf(DeviceTag tag, Sint32* value)
{
    const int sensor = theCore != 0 ? theCore->Devices().Sensor(tag) : -1;
    if (sensor < 0) return 0;
    *value = theCore->Sensors().sensor[sensor];
    return &theCore->Robot()->sensors[sensor];
}

void
distance_sensor_enable(DeviceTag, unsigned short)
{
}

void
distance_sensor_disable(DeviceTag)
{
}

unsigned short
distance_sensor_get_value(DeviceTag tag)
{
    Sint32 micrometres = 0;
    const SensorConstants* sensor = SensorOf(tag, &micrometres);
    if (sensor == 0 || sensor->kind != sensorkindLENGTH || micrometres < 0) return 0;
    return (unsigned short)(micrometres / 1000);
}

void
touch_sensor_enable(DeviceTag, unsigned short)
{
}

void
touch_sensor_disable(DeviceTag)
{
}

unsigned short
touch_sensor_get_value(DeviceTag tag)
{
    Sint32 value = 0;
    const SensorConstants* sensor = SensorOf(tag, &value);
    return sensor != 0 && sensor->touchLimit >= 0 && value > sensor->touchLimit;
}

void
accelerometer_enable(DeviceTag, unsigned short)
{
}

void
accelerometer_disable(DeviceTag)
{
}

const float*
accelerometer_get_values(DeviceTag tag)
{
    static float values[3];
    values[0] = values[1] = values[2] = 0.0f;
    Sint32 ignored = 0;
    const SensorConstants* sensor = SensorOf(tag, &ignored);
    if (sensor == 0 || sensor->kind != sensorkindACCELERATION) return values;
    const RobotConstants* robot = theCore->Robot();
    // Returns the values of all three axes of the accelerometer, whichever axis `tag` belongs to,
    // as later versions of Webots do.  RobotConstants lists the axes in the order of the result:
    // front, right, up.
    int axis = 0;
    for (int i = 0; i < robot->numSensors && axis < 3; i++) {
        if (robot->sensors[i].kind != sensorkindACCELERATION) continue;
        values[axis++] = (float)(theCore->Sensors().sensor[i] * 1e-6);
    }
    return values;
}

void
thermometer_enable(DeviceTag, unsigned short)
{
}

void
thermometer_disable(DeviceTag)
{
}

float
thermometer_get_value(DeviceTag tag)
{
    Sint32 value = 0;
    const SensorConstants* sensor = SensorOf(tag, &value);
    if (sensor == 0 || sensor->kind != sensorkindTEMPERATURE) return 0.0f;
    return (float)(value * 1e-6);
}
