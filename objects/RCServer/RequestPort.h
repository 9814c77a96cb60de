//
// The functions of the robot that RequestHandler needs.  RCServer implements them with OPEN-R
// calls; the unit tests implement them with a simulated robot.
//

#ifndef RequestPort_h_DEFINED
#define RequestPort_h_DEFINED

#include <string>
#include <vector>

#include "Messages.h"
#include "RemoteProtocol.h"

class RequestPort {
public:
    virtual ~RequestPort() {}

    // Sends a command to JointMover, or keeps it until JointMover is ready.  Returns false when too
    // many commands are kept already.
    virtual bool PostMover(const MoverCommand& command) = 0;

    // Sends changes of LEDs and ears to Controller.  Earlier changes that could not be sent yet are
    // sent with them.
    virtual void PostLedEar(const LedEarState& change) = 0;

    // Reads a file of the Memory Stick.  On failure, returns false and sets `error` to the reason.
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                          std::string* error) = 0;

    // Reads the remaining capacity of the battery in percent and its temperature in 0.01 degree
    // Celsius.
    virtual void ReadBattery(Sint32* capacity, Sint32* temperature) = 0;

    // Reads the power status.  Returns false when the robot does not report its power status.
    virtual bool ReadPower(RcPower* power) = 0;

    // Reads the P, I and D gain of a joint and their shifts.  Returns false when the gain is
    // disabled; then all six values are 0.
    virtual bool ReadGains(int joint, Uint16 gains[6]) = 0;

    // Begins to receive images of the camera if `wanted` is true, and otherwise stops receiving
    // them.
    virtual void WantImage(bool wanted) = 0;

    // Shuts the robot down as soon as the present answer was sent.  With `reboot`, the robot boots
    // again at once.
    virtual void EndRun(bool reboot) = 0;
};

#endif  // RequestPort_h_DEFINED
