#include "Talker.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <string.h>

#include "Line.h"

static const char* const TEXTS[] = {"good morning", "it is a fine day", "good night"};
static const int NUM_TEXTS = sizeof(TEXTS) / sizeof(TEXTS[0]);

OStatus
Talker::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Talker::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Talker::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Talker::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Sends the next line, because the listener is ready for it.  The first ready may come before our
// own DoStart, if the listener was started first; this object does not depend on the order.
void
Talker::ReadySay(const OReadyEvent& event)
{
    if (!event.IsAssert()) return;  // the listener has withdrawn its ready
    if (numSaid_ == NUM_TEXTS) {
        OSYSPRINT(("Talker: the listener has heard it all\n"));
        return;  // sends nothing, so no further ready comes
    }
    Say(TEXTS[numSaid_]);
}

// Passes a local variable to SetData(), which copies it.
void
Talker::Say(const char* text)
{
    Line line;
    memset(&line, 0, sizeof(line));
    line.number = ++numSaid_;
    strncpy(line.text, text, LINE_SIZE - 1);
    subject[sbjSay]->SetData(&line, sizeof(line));
    subject[sbjSay]->NotifyObservers();
}
