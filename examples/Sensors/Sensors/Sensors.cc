#include "Sensors.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/OUnits.h>
#include <OPENR/core_macro.h>

// Locators of the sensors, in the order of the enumeration.
const char* const Sensors::LOCATORS[] = {
    "PRM:/r1/c1/c2/c3/p1-Sensor:p1",  // 10^-6 m
    "PRM:/r6/s1-Sensor:s1",           // oswitchOFF, oswitchON
    "PRM:/a3-Sensor:a3",              // 10^-6 m/s^2, includes gravity: negative while the robot
                                      // stands
    "PRM:/r6/t1-Sensor:t1",           // 10^-6 degree Celsius
    "PRM:/r1/c1-Joint2:j1"            // 10^-6 rad
};

Sensors::Sensors() : isFound_(false), numVectors_(0), nextFrame_(0), numLost_(0)
{
    for (int i = 0; i < NUM_SENSORS; i++) {
        id_[i] = oprimitiveID_UNDEF;
        element_[i] = -1;
    }
}

OStatus
Sensors::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    for (int i = 0; i < NUM_SENSORS; i++) {
        const OStatus status = OPENR::OpenPrimitive(LOCATORS[i], &id_[i]);
        if (status == oSUCCESS) continue;
        OSYSLOG1((osyslogERROR, "Sensors: cannot open %s, status %u", LOCATORS[i],
                  (unsigned)status));
        return oFAIL;
    }
    return oSUCCESS;
}

OStatus
Sensors::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Sensors::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Sensors::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Prints the newest values.  A vector of four frames comes every 32 ms.  An object that needs more
// time gets fewer vectors, but never an old one.
void
Sensors::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(0);
    const OSensorFrameInfo* info = vector->GetInfo(0);
    if (!isFound_) {
        FindElements(vector);
        OSYSPRINT(("Sensors: %u in a vector, %u frames of each\n",
                   (unsigned)vector->vectorInfo.numData, (unsigned)info->numFrames));
    } else {
        numLost_ += info->frameNumber - nextFrame_;
    }
    nextFrame_ = info->frameNumber + info->numFrames;
    if (++numVectors_ % VECTORS_PER_LINE == 0) Print(vector);
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

// Finds the elements of the sensors by their primitive ids.  The place of an element depends on the
// model of the robot, but stays the same from vector to vector.
void
Sensors::FindElements(OSensorFrameVectorData* vector)
{
    isFound_ = true;
    const int numElements = (int)vector->vectorInfo.numData;
    for (int i = 0; i < NUM_SENSORS; i++) {
        for (int e = 0; e < numElements; e++) {
            if (vector->GetInfo(e)->primitiveID == id_[i]) element_[i] = e;
        }
    }
}

// Returns the value in the last frame of the vector.
slongword
Sensors::Newest(OSensorFrameVectorData* vector, int sensor) const
{
    const int element = element_[sensor];
    if (element < 0) return 0;
    const int last = (int)vector->GetInfo(element)->numFrames - 1;
    return vector->GetData(element)->frame[last].value;
}

void
Sensors::Print(OSensorFrameVectorData* vector)
{
    OSYSPRINT(("Sensors: distance %d cm, back switch %s, up %.1f m/s^2, %.1f C, neck %.1f deg, "
               "%u frames lost\n",
               (int)(Newest(vector, DISTANCE) / 10000),
               Newest(vector, BACK_SWITCH) == (slongword)oswitchON ? "on" : "off",
               Newest(vector, UP) / 1000000.0, Newest(vector, TEMPERATURE) / 1000000.0,
               degrees(Newest(vector, NECK_TILT) / 1000000.0), (unsigned)numLost_));
}
