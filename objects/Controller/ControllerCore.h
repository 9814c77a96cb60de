//
// Controller without OPEN-R: the control loop and the buffers behind the functions a controller
// calls (Hohl 2004, sections 5.3.3 to 5.3.7).
//
// The loop is paced by LED vectors: each lasts the time step the controller asked for, and its
// end calls the run function again.  What the run function commands goes into buffers, and from
// there into vectors and messages after it.  Values of the remote control go into the
// same buffers when they arrive, so those of the run function win.
//
// A controller that loops by itself calls robot_step() instead; then the end of the LED vector lets
// robot_step() return.  Only where ControllerPort has a stack for it: not on the robot.
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

    // The robot stands: runs the controller's main function, and the loop from then on.
    void Execute(int (*controllerMain)());

    // The robot is shut down.
    void Die();

    // News of the robot.
    void SetSensors(const SensorValues& values) { sensors_ = values; }
    void LedReady();
    void EarReady();
    void BatchMoverReady();
    void RemoteLights(const LedEarState& change);

    // The ears of `mask` have a position in the key frame that a motion has reached: on or
    // off, bit i for plunger i.
    void MotionEars(Uint32 mask, Uint32 on);

    // Called by the functions of the controller's interface.
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
    // Where the controller's code is running.
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
    std::vector<std::string> unknown_;  // devices asked for in vain

    void (*die_)();
    int (*main_)();
    int (*run_)(int);
    Place place_;
    bool isStepping_;  // the main function waits in robot_step()
    int stepFrames_;   // of the LED vectors

    Uint32 ledOn_, earOn_;
    bool ledChanged_;  // by remote control while no loop runs
    bool earChanged_;
    bool batchChanged_;
    BatchMoverCommand batch_;
};

#endif  // ControllerCore_h_DEFINED
