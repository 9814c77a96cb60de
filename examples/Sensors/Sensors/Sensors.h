//
// Sensors prints some sensors of the ERS-210, about once a second.
//
//   Sensors.Sensor <- OVirtualRobotComm.Sensor
//

#ifndef Sensors_h_DEFINED
#define Sensors_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "def.h"

class Sensors : public OObject {
public:
    Sensors();
    virtual ~Sensors() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifySensor(const ONotifyEvent& event);

private:
    enum { DISTANCE, BACK_SWITCH, UP, TEMPERATURE, NECK_TILT, NUM_SENSORS };

    static const char* const LOCATORS[NUM_SENSORS];
    static const int VECTORS_PER_LINE = 31;  // number of vectors of 32 ms from line to line: 992 ms

    void FindElements(OSensorFrameVectorData* vector);
    slongword Newest(OSensorFrameVectorData* vector, int sensor) const;
    void Print(OSensorFrameVectorData* vector);

    OPrimitiveID id_[NUM_SENSORS];
    int element_[NUM_SENSORS];  // index of each sensor's element in the vector; -1: there is none
    bool isFound_;
    int numVectors_;
    longword nextFrame_;  // frame number that the next vector should have
    longword numLost_;    // number of frames that were missed
};

#endif  // Sensors_h_DEFINED
