//
// Controller without OPEN-R: the control loop and the buffers behind the functions a controller
// calls (Hohl 2004, sections 5.3.3 to 5.3.7).
//
// LED vectors are the clock of the loop: each lasts the time step that the controller asked for,
// and at its end the run function is called again.  Commands of the run function go into buffers,
// and are sent after it as vectors and messages.  Values of the remote control go into the same
// buffers when they arrive, so later values of the run function replace them.
//
// A controller with a loop of its own calls robot_step() instead.  It returns at the end of the LED
// vector.  This works only where ControllerPort has a second stack, which the robot has not.
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

    // Runs the controller's main function, and the loop from then on.  Called when the robot
    // stands.
    void Execute(int (*controllerMain)());

    // Ends the controller, because the robot is shut down.
    void Die();

    // Take new sensor values, readies and values of the remote control.
    void SetSensors(const SensorValues& values) { sensors_ = values; }
    void LedReady();
    void EarReady();
    void BatchMoverReady();
    void RemoteLights(const LedEarState& change);

    // Sets the ears of `mask` to their positions in the key frame that a motion has reached.  Bit i
    // is plunger i; a set bit in `on` is on.
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
    // The function of the controller that runs.
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
    std::vector<std::string> unknown_;  // unknown devices that were reported

    void (*die_)();
    int (*main_)();
    int (*run_)(int);
    Place place_;
    bool isStepping_;  // whether the main function waits in robot_step()
    int stepFrames_;   // length of the LED vectors

    Uint32 ledOn_, earOn_;
    bool ledChanged_;  // whether the remote control changed LEDs while no loop runs
    bool earChanged_;
    bool batchChanged_;
    BatchMoverCommand batch_;
};

#endif  // ControllerCore_h_DEFINED
