//
// PowerMonitor shuts the robot down when the pause button is pressed or the battery is low.
//
// It has no services.  Its only input is the message of the power manager.  Without such an object
// the robot cannot be switched off in good order.
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

    // Needed by the generated stub.  All pointers stay 0, because the object has no services.
    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    // Called when a bit of the power status has changed.
    void UpdatePowerStatus(void* msg);

private:
    void PrintPowerStatus(const OPowerStatus& status);
    void ShutdownRobot();
};

#endif  // PowerMonitor_h_DEFINED
