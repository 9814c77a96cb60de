//
// Recorder counts the readings and prints a line when all have arrived.
//
//   Recorder.Value <- Thermometer.Value, Barometer.Value
//

#ifndef Recorder_h_DEFINED
#define Recorder_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Recorder : public OObject {
public:
    Recorder() : numReadings_(0) {}
    virtual ~Recorder() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyValue(const ONotifyEvent& event);

private:
    static const int NUM_WANTED = 6;  // three readings from each of the two instruments

    int numReadings_;
};

#endif  // Recorder_h_DEFINED
