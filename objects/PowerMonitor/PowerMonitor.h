//
// PowerMonitor ends the run when somebody presses the pause button or the battery is low.
//
// It has no services; its one input is the message of the power manager.  Without an object that
// does this the robot cannot be switched off in good order.
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

    // The generated stub wants them; nothing is made or connected.
    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    // Something about power has changed.
    void UpdatePowerStatus(void* msg);

private:
    void PrintPowerStatus(const OPowerStatus& status);
    void ShutdownRobot();
};

#endif  // PowerMonitor_h_DEFINED
