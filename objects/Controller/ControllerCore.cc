#include "ControllerCore.h"

#include <string.h>

#include <algorithm>

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
      main_(0),
      run_(0),
      place_(NOWHERE),
      isStepping_(false),
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
ControllerCore::CallMain(void* core)
{
    ((ControllerCore*)core)->main_();
}

void
ControllerCore::Execute(int (*controllerMain)())
{
    main_ = controllerMain;
    place_ = IN_MAIN;
    port_->RunLoop(CallMain, this);
    place_ = NOWHERE;
    SendBuffers();
}

static const size_t MAX_UNKNOWN = 32;

// What is not there is remarked upon once: a run function may ask again and again.
int
ControllerCore::FindDevice(const char* locator)
{
    const int tag = devices_.Find(locator);
    if (tag != 0 || locator == 0 || unknown_.size() >= MAX_UNKNOWN) return tag;
    if (std::find(unknown_.begin(), unknown_.end(), locator) == unknown_.end()) {
        unknown_.push_back(locator);
        port_->UnknownDevice(locator);
    }
    return tag;
}

void
ControllerCore::Live(void (*reset)())
{
    if (reset != 0) reset();
}

// A run function may name its successor, which then begins with the next iteration.
void
ControllerCore::Run(int (*run)(int))
{
    run_ = run;
    if (run_ != 0 && place_ != IN_RUN) CallRun();
}

void
ControllerCore::Die()
{
    run_ = 0;
    isStepping_ = false;
    if (die_ != 0) die_();
    die_ = 0;
}

void
ControllerCore::CallRun()
{
    const Place from = place_;
    place_ = IN_RUN;
    const int asked = run_(0);
    place_ = from;
    SetTimeStep(asked);
}

void
ControllerCore::SetTimeStep(int askedMs)
{
    const int frames =
        askedMs > 0 ? Clamp((Sint32)(((Sint64)askedMs + FRAME_MS / 2) / FRAME_MS), 1, MAX_STEP_FRAMES)
                    : 1;
    if (frames * FRAME_MS != askedMs) port_->TimeStepRounded(askedMs, frames * FRAME_MS);
    stepFrames_ = frames;
}

// Returns when the LED vector that is sent now has ended, always 0 (synchronous mode).
// After robot_run() it never does: in Webots nothing comes after that, and two loops cannot share
// the LEDs.
int
ControllerCore::Step(int ms)
{
    if (place_ != IN_MAIN) {
        port_->Remark("robot_step() outside of main() does nothing; a run function returns its "
                      "time step instead");
        return 0;
    }
    if (run_ == 0) {
        SetTimeStep(ms);
        isStepping_ = true;
    } else {
        port_->Remark("robot_step() after robot_run(): main() ends here, the run function goes on");
    }
    place_ = NOWHERE;
    if (!port_->LeaveLoop()) {
        isStepping_ = false;
        port_->EndLoop();
    }
    place_ = IN_MAIN;
    return 0;
}

// exit() ends the method that calls it and nothing else (Programmer's Guide, appendix A.2); for a
// controller it is the end, whatever loop it had begun.
void
ControllerCore::EndIfItDidNotReturn()
{
    if (place_ == NOWHERE) return;
    place_ = NOWHERE;
    run_ = 0;
}

// The LED vector sent last has ended.  Not ready after all means that one that waited has just
// been sent; its own end comes.
void
ControllerCore::LedReady()
{
    if (!port_->IsLedReady()) return;
    EndIfItDidNotReturn();
    if (run_ != 0) {
        CallRun();
    } else if (isStepping_) {
        isStepping_ = false;
        port_->ContinueLoop();
        place_ = NOWHERE;
    } else if (!ledChanged_) {
        return;
    }
    SendBuffers();
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
    if (!HasLoop()) SendEarsIfChanged();
}

void
ControllerCore::BatchMoverReady()
{
    if (!HasLoop()) SendBatchIfChanged();
}

void
ControllerCore::RemoteLights(const LedEarState& change)
{
    ChangeEars(change.earMask, change.earOn);
    ledOn_ = (ledOn_ & ~change.ledMask) | (change.ledOn & change.ledMask);
    EndIfItDidNotReturn();
    if (HasLoop()) return;  // with the next iteration
    ledChanged_ = true;
    if (port_->IsLedReady()) SendBuffers();
}

void
ControllerCore::MotionEars(Uint32 mask, Uint32 on)
{
    ChangeEars(mask, on);
    EndIfItDidNotReturn();
    if (!HasLoop()) SendEarsIfChanged();  // otherwise with the next iteration
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
    ChangeEars(1u << ear, on ? 1u << ear : 0);
}

void
ControllerCore::ChangeEars(Uint32 mask, Uint32 on)
{
    const Uint32 ears = (earOn_ & ~mask) | (on & mask);
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
