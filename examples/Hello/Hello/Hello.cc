#include "Hello.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

// Runs while the image is loaded, before the system can be called: only sets members.
Hello::Hello()
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

// Makes what the object needs.  No object is connected yet.
OStatus
Hello::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    OSYSPRINT(("Hello: DoInit\n"));
    return oSUCCESS;
}

// Every object has had its DoInit, and CONNECT.CFG has been carried out.
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

// The robot is about to power off: send nothing any more.
OStatus
Hello::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("Hello: DoStop\n"));
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

// Every object has had its DoStop.
OStatus
Hello::DoDestroy(const OSystemEvent&)
{
    OSYSPRINT(("Hello: DoDestroy\n"));
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}
