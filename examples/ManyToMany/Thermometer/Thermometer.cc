#include "Thermometer.h"

#include <OPENR/core_macro.h>

#include <string.h>

#include "Reading.h"

// Readings in degrees Celsius.
static const slongword VALUES[] = {21, 22, 24};
static const int NUM_VALUES = sizeof(VALUES) / sizeof(VALUES[0]);

OStatus
Thermometer::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Thermometer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Thermometer::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Thermometer::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Sends the next reading when all observers are ready.  Each observer sends a ready of its own.  A
// reading for an observer that is not ready would wait, and the next reading would replace it.
void
Thermometer::ReadyValue(const OReadyEvent& event)
{
    if (!event.IsAssert() || !subject[sbjValue]->IsAllReady()) return;
    if (numSent_ == NUM_VALUES) return;
    Reading reading;
    memset(&reading, 0, sizeof(reading));
    strncpy(reading.name, "temperature", READING_NAME_SIZE - 1);
    reading.value = VALUES[numSent_++];
    subject[sbjValue]->SetData(&reading, sizeof(reading));
    subject[sbjValue]->NotifyObservers();
}
