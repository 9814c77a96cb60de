#include "Lights.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

// The LEDs around the eyes of the ERS-210: l1 to l3 left, from below; l6 to l4 right, from above.
static const char* const LOCATORS[] = {
    "PRM:/r1/c1/c2/c3/l1-LED2:l1",
    "PRM:/r1/c1/c2/c3/l2-LED2:l2",
    "PRM:/r1/c1/c2/c3/l3-LED2:l3",
    "PRM:/r1/c1/c2/c3/l6-LED2:l6",
    "PRM:/r1/c1/c2/c3/l5-LED2:l5",
    "PRM:/r1/c1/c2/c3/l4-LED2:l4"
};

Lights::Lights() : round_(0), allOn_(0), numSent_(0)
{
    for (int i = 0; i < NUM_LEDS; i++) led_[i] = oprimitiveID_UNDEF;
}

// Makes the vectors here, once, because a robot whose program makes a new vector for each command
// runs out of memory.
OStatus
Lights::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    if (OpenLeds() != oSUCCESS) return oFAIL;
    round_ = NewRegion();
    allOn_ = NewRegion();
    if (round_ == 0 || allOn_ == 0) return oNO_MEMORY;
    FillRound((OCommandVectorData*)round_->Base());
    FillAllOn((OCommandVectorData*)allOn_->Base());
    return oSUCCESS;
}

OStatus
Lights::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Lights::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Lights::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

OStatus
Lights::OpenLeds()
{
    for (int i = 0; i < NUM_LEDS; i++) {
        const OStatus status = OPENR::OpenPrimitive(LOCATORS[i], &led_[i]);
        if (status == oSUCCESS) continue;
        OSYSLOG1((osyslogERROR, "Lights: cannot open %s, status %u", LOCATORS[i],
                  (unsigned)status));
        return status;
    }
    return oSUCCESS;
}

RCRegion*
Lights::NewRegion()
{
    MemoryRegionID id;
    OCommandVectorData* vector;
    if (OPENR::NewCommandVectorData(NUM_LEDS, &id, &vector) != oSUCCESS) return 0;
    vector->SetNumData(NUM_LEDS);
    return new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset, (void*)vector,
                        vector->vectorInfo.totalSize);
}

// Fills the vector with a whole round: six frames for each LED, each of the length PERIOD.  In
// frame f only light f is on.
void
Lights::FillRound(OCommandVectorData* vector)
{
    for (int i = 0; i < NUM_LEDS; i++) {
        vector->GetInfo(i)->Set(odataLED_COMMAND2, led_[i], NUM_LEDS);
        OLEDCommandValue2* value = (OLEDCommandValue2*)vector->GetData(i)->value;
        for (int f = 0; f < NUM_LEDS; f++) {
            value[f].led = f == i ? oledON : oledOFF;
            value[f].period = PERIOD;
            value[f].reserved = 0;
        }
    }
}

// Fills the vector with one frame that switches all lights on.  They stay on, because no vector
// follows.
void
Lights::FillAllOn(OCommandVectorData* vector)
{
    for (int i = 0; i < NUM_LEDS; i++) {
        vector->GetInfo(i)->Set(odataLED_COMMAND2, led_[i], 1);
        OLEDCommandValue2* value = (OLEDCommandValue2*)vector->GetData(i)->value;
        value->led = oledON;
        value->period = 1;
        value->reserved = 0;
    }
}

// Sends the next vector.  The first ready means that the robot is ready for vectors, each later
// ready that a vector has ended.  Readies come even when DoInit has failed.
void
Lights::ReadyLed(const OReadyEvent& event)
{
    if (!event.IsAssert() || allOn_ == 0 || numSent_ > NUM_ROUNDS) return;
    RCRegion* region = round_;
    if (numSent_ < NUM_ROUNDS) {
        OSYSPRINT(("Lights: round %d\n", numSent_ + 1));
    } else {
        OSYSPRINT(("Lights: all on\n"));
        region = allOn_;
    }
    numSent_++;
    subject[sbjLed]->SetData(region);
    subject[sbjLed]->NotifyObservers();
}
