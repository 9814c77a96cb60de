//
// The part of Controller that does not use OPEN-R: the control loop and the buffers behind the
// functions that a controller program calls (Hohl 2004, sections 5.3.3 to 5.3.7).
//
// LED vectors (messages with commands for all LEDs) are the clock of the loop.  Each LED vector
// lasts the time step that the program asked for, and at its end the program's run function is
// called again.  The commands of the run function go into buffers, and are sent as vectors and
// messages after the function has returned.  Values of the remote control go into the same buffers
// when they arrive, so later values of the run function replace them.
//
// A program may also be an endless loop that calls robot_step() in each iteration.  robot_step()
// returns at the end of the LED vector.  This works only where ControllerPort has a second stack,
// which the robot does not have.
//

#ifndef ControllerCore_h_DEFINED
#define ControllerCore_h_DEFINED

#include "ControllerPort.h"
#include "DeviceTable.h"
#include "SensorValues.h"

class ControllerCore {
public:
    // `port` must outlive the core.
    explicit ControllerCore(ControllerPort* port);

    void Begin(const RobotConstants* robot);
    const RobotConstants* Robot() const { return robot_; }
    const DeviceTable& Devices() const { return devices_; }
    const SensorValues& Sensors() const { return sensors_; }
    ControllerPort* Port() { return port_; }

    // Runs the main() of the controller program.  If main() is an endless loop, it is suspended in
    // robot_step() and continued with later sensor values.  Called when the robot stands.
    void Execute(int (*controllerMain)());

    // Ends the controller program and calls the function that OnDie() has set.  Called when the
    // object is stopped, as at the shutdown of the robot.
    void Die();

    // Stores the newest sensor values, which the controller program can then read.
    void SetSensors(const SensorValues& values) { sensors_ = values; }

    // Begins the next iteration of the program's loop.  If the program has no loop, only sends the
    // LEDs that the remote control has changed.  Called when the observer of LED vectors has become
    // ready.
    void LedReady();
    // Sends a change of the ears that could not be sent before.  Called when the observer of ear
    // vectors has become ready.
    void EarReady();
    // Sends changes of joint commands that could not be sent before.  Called when JointMover has
    // become ready for the buffer of joint commands.
    void BatchMoverReady();

    // Puts the LEDs and ears that the remote control has set (`change`) into the buffers from which
    // the next LED and ear vectors are made.
    void RemoteLights(const LedEarState& change);

    // Sets the ears of `mask` to their positions in the key frame (posture) that a motion has
    // reached.  In both arguments, bit i stands for ear i; a set bit in `on` means that the ear is
    // on.
    void MotionEars(Uint32 mask, Uint32 on);

    // The functions below do the work of the functions of include/device, which the controller
    // program calls.
    int FindDevice(const char* locator);
    void Live(void (*reset)());
    void OnDie(void (*die)()) { die_ = die; }
    void Run(int (*run)(int));
    int Step(int ms);
    void SetLed(int led, bool on);
    void SetEar(int ear, bool on);
    void SetPosition(int joint, double rad);
    void SetVelocity(int joint, double radPerSecond);
    void SetAcceleration(int joint, double radPerSecond2);
    void MotorOff(int joint);

private:
    // The function of the program that runs now: none, main() or a run function.
    enum Place { NOWHERE, IN_MAIN, IN_RUN };

    static void CallMain(void* core);
    bool HasLoop() const { return run_ != 0 || isStepping_; }
    void CallRun();
    void EndIfItDidNotReturn();
    void SetTimeStep(int askedMs);
    void SendBuffers();
    void SendBatchIfChanged();
    void SendEarsIfChanged();
    void ChangeEars(Uint32 mask, Uint32 on);
    void Change(Sint32* value, Sint32 newValue);

    ControllerPort* port_;
    const RobotConstants* robot_;
    DeviceTable devices_;
    SensorValues sensors_;
    std::vector<std::string> unknown_;  // names of unknown devices that were reported already

    void (*die_)();
    int (*main_)();
    int (*run_)(int);
    Place place_;
    bool isStepping_;  // whether the main function waits in robot_step()
    int stepFrames_;   // length of the LED vectors, in frames of 8 ms

    Uint32 ledOn_, earOn_;
    bool ledChanged_;  // whether the remote control changed LEDs while no loop runs
    bool earChanged_;
    bool batchChanged_;
    BatchMoverCommand batch_;
};

#endif  // ControllerCore_h_DEFINED
