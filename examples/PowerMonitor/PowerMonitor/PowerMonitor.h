//
// PowerMonitor prints the state of the battery, and switches the robot off when its pause button is
// pressed or the battery is low.
//
// Without an object that does this, the button has no effect.
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

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void PowerChanged(void* msg);

private:
    OServiceEntry Entry() const;
    void Print(const OPowerStatus& status);
    void Shutdown();

    bool isGoingDown_;
};

#endif  // PowerMonitor_h_DEFINED
