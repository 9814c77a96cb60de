//
// What the requests of remote clients need of the robot.  RCServer answers with OPEN-R calls,
// tests with a robot of their own.
//

#ifndef RequestPort_h_DEFINED
#define RequestPort_h_DEFINED

#include <string>
#include <vector>

#include "Messages.h"

class RequestPort {
public:
    virtual ~RequestPort() {}

    // Sends a command to JointMover, or keeps it until JointMover is ready.  Returns false
    // when too many are kept already.
    virtual bool PostMover(const MoverCommand& command) = 0;

    // Sends LEDs and ears to Controller; what was sent before and is still waiting is kept.
    virtual void PostLedEar(const LedEarState& change) = 0;

    // A file of the Memory Stick, or false and why not.
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                          std::string* error) = 0;

    // Remaining capacity in %, temperature in 0.01 degree Celsius.
    virtual void ReadBattery(Sint32* capacity, Sint32* temperature) = 0;
};

#endif  // RequestPort_h_DEFINED
