//
// Display prints the readings of all instruments when they arrive.
//
//   Display.Value <- Thermometer.Value, Barometer.Value
//

#ifndef Display_h_DEFINED
#define Display_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Display : public OObject {
public:
    Display() {}
    virtual ~Display() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyValue(const ONotifyEvent& event);
};

#endif  // Display_h_DEFINED
