#include "ControllerCore.h"

#include <string.h>

#include "Angle.h"

// Time step before a controller asks for one, and of LED vectors when none runs: 32 ms, the
// shorter of the two the report recommends (5.3.4).
static const int DEFAULT_STEP_FRAMES = 4;

static const int FRAME_MS = 8;

// The period of an LED command is a 16-bit number of frames.
static const int MAX_STEP_FRAMES = 65535;

ControllerCore::ControllerCore(ControllerPort* port)
    : port_(port),
      robot_(0),
      die_(0),
      run_(0),
      isExecuting_(false),
      stepFrames_(DEFAULT_STEP_FRAMES),
      ledOn_(0),
      earOn_(0),
      ledChanged_(false),
      earChanged_(false),
      batchChanged_(false)
{
    memset(&sensors_, 0, sizeof(sensors_));
    sensors_.frame = NO_SENSOR_FRAME;
    memset(&batch_, 0, sizeof(batch_));
}

void
ControllerCore::Begin(const RobotConstants* robot)
{
    robot_ = robot;
    devices_.Begin(robot);
    for (int j = 0; j < robot->numJoints; j++) {
        batch_.joint[j].speed = robot->joints[j].maxSpeedCdeg;
        batch_.joint[j].acceleration = robot->defaultAccelerationCdeg;
    }
}

// ---- The loop ------------------------------------------------------------------------

void
ControllerCore::Execute(int (*controllerMain)())
{
    isExecuting_ = true;
    controllerMain();
    isExecuting_ = false;
    SendBuffers();
}

void
ControllerCore::Live(void (*reset)())
{
    if (reset != 0) reset();
}

void
ControllerCore::Run(int (*run)(int))
{
    run_ = run;
    if (run_ != 0) CallRun();
}

void
ControllerCore::Die()
{
    run_ = 0;
    if (die_ != 0) die_();
    die_ = 0;
}

void
ControllerCore::CallRun()
{
    const int asked = run_(0);
    const int frames = asked > 0 ? Clamp((asked + FRAME_MS / 2) / FRAME_MS, 1, MAX_STEP_FRAMES) : 1;
    if (frames * FRAME_MS != asked) port_->TimeStepRounded(asked, frames * FRAME_MS);
    stepFrames_ = frames;
}

// The LED vector sent last has ended.  Not ready after all means that one that waited has just
// been sent; its own end comes.
void
ControllerCore::LedReady()
{
    if (isExecuting_ || !port_->IsLedReady()) return;
    if (run_ != 0) {
        CallRun();
        SendBuffers();
    } else if (ledChanged_) {
        SendBuffers();
    }
}

// The LED vector is sent in any case: without it the loop would stand still.
void
ControllerCore::SendBuffers()
{
    SendBatchIfChanged();
    SendEarsIfChanged();
    ledChanged_ = false;
    port_->SendLeds(ledOn_, stepFrames_);
}

// What is not ready now is tried again with the next iteration.
void
ControllerCore::SendEarsIfChanged()
{
    if (!earChanged_ || !port_->IsEarReady()) return;
    earChanged_ = false;
    port_->SendEars(earOn_);
}

void
ControllerCore::SendBatchIfChanged()
{
    if (!batchChanged_ || !port_->IsBatchMoverReady()) return;
    batchChanged_ = false;
    port_->SendBatch(batch_);
}

// The next two are for a controller without a loop, whose next iteration never comes.
void
ControllerCore::EarReady()
{
    if (run_ == 0 && !isExecuting_) SendEarsIfChanged();
}

void
ControllerCore::BatchMoverReady()
{
    if (run_ == 0 && !isExecuting_) SendBatchIfChanged();
}

void
ControllerCore::RemoteLights(const LedEarState& change)
{
    const Uint32 ears = (earOn_ & ~change.earMask) | (change.earOn & change.earMask);
    if (ears != earOn_) earChanged_ = true;
    earOn_ = ears;
    ledOn_ = (ledOn_ & ~change.ledMask) | (change.ledOn & change.ledMask);
    if (run_ != 0) return;  // with the next iteration
    ledChanged_ = true;
    if (port_->IsLedReady()) SendBuffers();
}

// ---- Buffers -------------------------------------------------------------------------

static Uint32
WithBit(Uint32 bits, int index, bool on)
{
    return on ? bits | (1u << index) : bits & ~(1u << index);
}

void
ControllerCore::SetLed(int led, bool on)
{
    ledOn_ = WithBit(ledOn_, led, on);
}

void
ControllerCore::SetEar(int ear, bool on)
{
    const Uint32 ears = WithBit(earOn_, ear, on);
    if (ears != earOn_) earChanged_ = true;
    earOn_ = ears;
}

void
ControllerCore::Change(Sint32* value, Sint32 newValue)
{
    if (*value != newValue) batchChanged_ = true;
    *value = newValue;
}

// `value` x `scale`, rounded and brought between the limits before it becomes an integer.
static Sint32
Scaled(double value, double scale, Sint32 low, Sint32 high)
{
    const double scaled = value * scale;
    if (scaled <= low) return low;
    if (scaled >= high) return high;
    return scaled >= 0 ? (Sint32)(scaled + 0.5) : -(Sint32)(0.5 - scaled);
}

static const double URAD_PER_RAD = 1e6;
static const double CDEG_PER_RAD = 5729.577951308232;

void
ControllerCore::SetPosition(int joint, double rad)
{
    if (rad != rad) return;  // not a number: no position
    const JointConstants& limits = robot_->joints[joint];
    Change(&batch_.joint[joint].position,
           Scaled(rad, URAD_PER_RAD, limits.minUrad, limits.maxUrad));
    Change(&batch_.joint[joint].flags, batchPOSITION_GIVEN);
}

void
ControllerCore::SetVelocity(int joint, double radPerSecond)
{
    if (radPerSecond != radPerSecond) return;
    const JointConstants& limits = robot_->joints[joint];
    Change(&batch_.joint[joint].speed,
           Scaled(radPerSecond, CDEG_PER_RAD, limits.minSpeedCdeg, limits.maxSpeedCdeg));
}

void
ControllerCore::SetAcceleration(int joint, double radPerSecond2)
{
    if (radPerSecond2 != radPerSecond2) return;
    Change(&batch_.joint[joint].acceleration,
           Scaled(radPerSecond2, CDEG_PER_RAD, robot_->minAccelerationCdeg,
                  robot_->maxAccelerationCdeg));
}

void
ControllerCore::MotorOff(int joint)
{
    Change(&batch_.joint[joint].flags, batch_.joint[joint].flags | batchMOTOR_OFF);
}
