//
// PowerMonitor shuts the robot down when the pause button is pressed or the battery is low.
//
// PowerMonitor has no services (connections to other objects).  Its only input is the message of
// the power manager.  Without an object like PowerMonitor the robot cannot be shut down properly.
//

#ifndef PowerMonitor_h_DEFINED
#define PowerMonitor_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OPower.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class PowerMonitor : public OObject {
public:
    PowerMonitor();
    virtual ~PowerMonitor() {}

    // Pointers that the generated stub needs.  All of them stay 0, because the object has no
    // services.
    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    // Shuts the robot down if `msg`, an OPowerStatusMessage, says that the pause button is pressed
    // or the battery is low.  Called when a bit of the power status has changed.
    void UpdatePowerStatus(void* msg);

private:
    void PrintPowerStatus(const OPowerStatus& status);
    void ShutdownRobot();
};

#endif  // PowerMonitor_h_DEFINED
