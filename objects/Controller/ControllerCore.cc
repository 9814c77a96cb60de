#include "ControllerCore.h"

#include <string.h>

#include <algorithm>

#include "Angle.h"

// Time step, in frames of 8 ms, while no controller program runs, and until a program asks for
// another time step.  It is 32 ms, the shorter of the two time steps that Hohl 2004, 5.3.4,
// recommends.
static const int DEFAULT_STEP_FRAMES = 4;

static const int FRAME_MS = 8;

// Longest time step of a program, in frames.  An LED command lasts one time step, and the field for
// its length in frames has 16 bits.
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
        // JointMover begins with the same values and carries out only differences from them, so the
        // first buffer changes only what the program has set.
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

// Returns the tag of a device, or 0 if the robot does not have it.  Reports each unknown device
// only once, because a run function may ask for the device again and again.
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

// Sets the run function: the function of the program that is called in each iteration of the loop.
// If main() calls Run(), also calls the run function at once.  If a run function calls Run(), the
// new function is called from the next iteration on.
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

// Does the work of robot_step(): returns when the LED vector that is sent now has ended.  The
// result is always 0, as in Webots' synchronous mode.  After robot_run() this function does not
// return: in Webots no code runs after robot_run(), and two loops cannot share the LEDs.
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
    // SuspendLoop() suspends main() here, and returns true when the time step has ended and main()
    // goes on.  It returns false if main() cannot be suspended, as on the robot.  Then the program
    // ends.
    if (!port_->SuspendLoop()) {
        isStepping_ = false;
        port_->EndLoop();
    }
    place_ = IN_MAIN;
    return 0;
}

// Ends the program if its code has called exit().  exit() ends only the method that is running, not
// the object (Programmer's Guide, appendix A.2).  So exit() leaves place_ as it was: place_ says
// that code of the program is running, although it has ended.  This is how the call of exit() is
// recognised here.
void
ControllerCore::EndIfItDidNotReturn()
{
    if (place_ == NOWHERE) return;
    place_ = NOWHERE;
    run_ = 0;
}

// Begins the next iteration, because the last LED vector has ended.  Does nothing if the effector
// is not ready any more, because it has then just received an LED vector that waited.  The end of
// that vector will call this function again.
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
        // Records that no code of the program runs, because main() may have ended normally here.
        // Without this record, EndIfItDidNotReturn() would take the normal end for a call of
        // exit().
        place_ = NOWHERE;
    } else if (!ledChanged_) {
        return;
    }
    SendBuffers();
}

// Sends the LEDs, ears and joint commands that have changed.  Sends the LED vector even without a
// change, because the end of this vector begins the next iteration.
void
ControllerCore::SendBuffers()
{
    SendBatchIfChanged();
    SendEarsIfChanged();
    ledChanged_ = false;
    port_->SendLeds(ledOn_, stepFrames_);
}

// Sends the states of the ears (on or off) if they have changed.  When OVirtualRobotComm is not
// ready for a vector, the change is kept and sent by a later call.
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

// Called when the observer of ear vectors has become ready.  Sends a change of the ears that could
// not be sent before.  Does nothing if the program has a loop, because its next iteration sends the
// change.
void
ControllerCore::EarReady()
{
    if (!HasLoop()) SendEarsIfChanged();
}

// Called when JointMover has become ready for joint commands.  Sends changes of joint commands that
// could not be sent before.  Does nothing if the program has a loop, because its next iteration
// sends the changes.
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
    if (HasLoop()) return;  // the next iteration of the loop sends the changes
    ledChanged_ = true;
    if (port_->IsLedReady()) SendBuffers();
}

void
ControllerCore::MotionEars(Uint32 mask, Uint32 on)
{
    ChangeEars(mask, on);
    EndIfItDidNotReturn();
    if (!HasLoop()) SendEarsIfChanged();  // if a loop runs, its next iteration sends the ears
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

// Returns `value` x `scale`, rounded and limited to `low` and `high`.  The limits are tested before
// the conversion, because a number that does not fit an integer must not be converted.
static Sint32
Scaled(double value, double scale, Sint32 low, Sint32 high)
{
    const double scaled = value * scale;
    if (scaled <= low) return low;
    if (scaled >= high) return high;
    return scaled >= 0 ? (Sint32)(scaled + 0.5) : -(Sint32)(0.5 - scaled);
}

void
ControllerCore::SetPosition(int joint, double rad)
{
    if (rad != rad) return;  // ignores NaN, which is no position
    const JointConstants& limits = robot_->joints[joint];
    Change(&batch_.joint[joint].position,
           Scaled(rad, URAD_PER_RAD, limits.minUrad, limits.maxUrad));
    // Sets all flags anew and so clears batchMOTOR_OFF, because a position switches the joint on
    // again.
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
