#include "Hello.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

// Only sets members, because the constructor runs while the image is loaded, before the system can
// be called.
Hello::Hello()
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

// Makes everything that the object needs.  No object is connected yet.
OStatus
Hello::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    OSYSPRINT(("Hello: DoInit\n"));
    return oSUCCESS;
}

// Starts the work.  Every object has had its DoInit, and the connections of CONNECT.CFG were made.
OStatus
Hello::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;

    char design[orobotdesignNAME_MAX + 1] = "";
    OPENR::GetRobotDesign(design);
    OSYSPRINT(("Hello: DoStart\n"));
    OSYSPRINT(("Hello, world, from an %s!\n", design));
    return oSUCCESS;
}

// Stops sending, because the robot is about to switch off.
OStatus
Hello::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("Hello: DoStop\n"));
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

// Frees everything.  Every object has had its DoStop.
OStatus
Hello::DoDestroy(const OSystemEvent&)
{
    OSYSPRINT(("Hello: DoDestroy\n"));
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}
