#include "Teller.h"

#include <MCOOP.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <fstream>

Teller::Teller() : region(0), stick(omemorystickUNDEF), fails(false)
{
     OSYSPRINT(("T made %s\n", myOID_.IsValid() ? "with an id" : "without"));
}

OStatus
Teller::DoInit(const OSystemEvent& event)
{
    OSYSPRINT(("T init %d\n", (int)event.Reason()));
    NewComData;
    SetComData;
    RunFile("/MS/OPEN-R/MW/DATA/P/TINIT.TXT");
    return oSUCCESS;
}

OStatus
Teller::DoStart(const OSystemEvent& event)
{
    OSYSPRINT(("T start\n"));
    if (event.ParamSize() == sizeof(OBootParam)) stick = ((const OBootParam*)event.Param())->memoryStickStatus;
    ENABLE_ALL_SUBJECT;
    ASSERT_TO_ALL_OBSERVER;
    RunFile("/MS/OPEN-R/MW/DATA/P/TSTART.TXT");
    return fails ? oFAIL : oSUCCESS;
}

OStatus
Teller::DoStop(const OSystemEvent& event)
{
    if (event.ParamSize() == sizeof(OShutdownParam))
        OSYSPRINT(("T battery %d\n", ((const OShutdownParam*)event.Param())->batteryEnough));
    OSYSPRINT(("T stop %d\n", (int)event.Reason()));
    DISABLE_ALL_SUBJECT;
    DEASSERT_TO_ALL_OBSERVER;
    RunFile("/MS/OPEN-R/MW/DATA/P/TSTOP.TXT");
    return oSUCCESS;
}

OStatus
Teller::DoDestroy(const OSystemEvent&)
{
    OSYSPRINT(("T destroy\n"));
    DeleteComData;
    return oSUCCESS;
}

void
Teller::ReadyOut(const OReadyEvent& event)
{
    if (event.IsDeassert()) {
        OSYSPRINT(("T deassert\n"));
    } else {
        OSYSPRINT(("T ready %d refs %d\n", subject[sbjOut]->IsReady(), region == 0 ? 0 : region->NumberOfReference()));
    }
}

void Teller::ReadyLoop(const OReadyEvent&) {}

OStatus
Teller::ControlLoop(const OControlEvent& event)
{
    OSYSPRINT(("T control %s from %s\n", event.IsAddObserver() ? "add" : "remove", event.SubName()));
    return oSUCCESS;
}

OStatus
Teller::ConnectLoop(const OConnectEvent& event)
{
    OSYSPRINT(("T connect %d to %s\n", event.IsConnect(), event.SubName()));
    return oSUCCESS;
}

void
Teller::NotifyLoop(const ONotifyEvent& event)
{
    OSYSPRINT(("T heard itself: %d\n", *(const int*)event.Data(0)));
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void Teller::Command(void* msg) { Run((const char*)msg); }
void Teller::Tick(void* msg) { OSYSPRINT(("T tick %s\n", (const char*)msg)); }

// Brings this object down, when what it has done so far is known.
static void
Die()
{
    OID oid;
    Find("asked", &oid);
    *(volatile int*)16 = 1;
}

// Hands "delegate" on to its own entry, and "bequeath" to another object; anything else it answers
// itself, also "misguide" after it has tried to hand it on to an entry that does not exist.
void
Teller::Ask(void* msg)
{
    OSYSPRINT(("T asked %s\n", (const char*)msg));
    if (strcmp((const char*)msg, "silent") == 0) return;
    if (strcmp((const char*)msg, "delegate") == 0) {
        char word[] = "handed on";
        Selector selector;
        FindSelector("Ask", &selector);
        Delegate(myOID_, selector, word, sizeof word);
        return;
    }
    if (strcmp((const char*)msg, "misguide") == 0) OSYSPRINT(("T delegate %d\n", Delegate(myOID_, 40, msg, 9)));
    if (strcmp((const char*)msg, "bequeath") == 0) {
        char word[] = "answer";
        OID heir;
        Find("asked", &heir);
        Delegate(heir, 4, word, sizeof word);
        Die();
    }
    char answer[] = "an answer";
    if (strcmp((const char*)msg, "answer and die") == 0) {
        Reply(answer, sizeof answer);
        Die();
    }
    Return(answer, sizeof answer);
    OSYSPRINT(("never reached\n"));
}

void
Teller::RunFile(const char* path)
{
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) Run(line);
}

void
Teller::Run(const std::string& command)
{
    int value = 0, other = 0;
    OSubject* const out = subject[sbjOut];
    if (command == "fail") {
        fails = true;
    } else if (command == "stick?") {
        OSYSPRINT(("T booted with stick %d\n", (int)stick));
    } else if (command == "fatal") {
        OPENR::Fatal(ofatalMEMORY_STICK);
        OSYSPRINT(("T lives for the rest of the method\n"));
    } else if (sscanf(command.c_str(), "send %d", &value) == 1) {
        const OStatus set = out->SetData(&value, sizeof value);
        const OStatus notify = out->NotifyObservers();
        if (set != oSUCCESS || notify != oSUCCESS) OSYSPRINT(("T status %d %d\n", set, notify));
    } else if (sscanf(command.c_str(), "set %d", &value) == 1) {
        const OStatus set = out->SetData(&value, sizeof value);
        if (set != oSUCCESS) OSYSPRINT(("T status %d\n", set));
    } else if (command == "notify") {
        OSYSPRINT(("T notify %d\n", out->NotifyObservers()));
    } else if (command == "ready?") {
        OSYSPRINT(("T any %d ready %d all %d\n", out->IsAnyReady(), out->IsReady(), out->IsAllReady()));
    } else if (command == "region") {
        region = new RCRegion(sizeof(int));
        OSYSPRINT(("T refs %d\n", region->NumberOfReference()));
    } else if (sscanf(command.c_str(), "setregion %d", &value) == 1) {
        *(int*)region->Base() = value;
        out->SetData(region);
        OSYSPRINT(("T refs %d\n", region->NumberOfReference()));
    } else if (sscanf(command.c_str(), "hurry %d %d", &value, &other) == 2) {
        *(int*)region->Base() = value;
        out->SetData(region);
        out->NotifyObservers();
        *(int*)region->Base() = other;  // too early
    } else if (sscanf(command.c_str(), "regions %d", &value) == 1) {
        bool all = true;
        for (int i = 0; i < value; i++) all = (new RCRegion(sizeof(int)))->Base() != 0 && all;
        OSYSPRINT(("T %s\n", all ? "all" : "no more"));
    } else if (sscanf(command.c_str(), "wait %d", &value) == 1) {
        SystemTime begin, now;
        GetSystemTime(&begin);
        do {
            GetSystemTime(&now);
        } while (now < begin + SystemTime(value / 1000, value % 1000 * 1000));
        OSYSPRINT(("T waited\n"));
    } else if (command == "refs") {
        OSYSPRINT(("T refs %d\n", region->NumberOfReference()));
    } else if (sscanf(command.c_str(), "unit %d", &value) == 1) {
        OSYSPRINT(("T unit %d\n", out->SetNotifyUnitSize(value)));
    } else if (sscanf(command.c_str(), "buffer %d", &value) == 1) {
        OSYSPRINT(("T buffer %d\n", out->SetBufferSize(value)));
    } else if (sscanf(command.c_str(), "loop %d", &value) == 1) {
        subject[sbjLoop]->SetData(&value, sizeof value);
        subject[sbjLoop]->NotifyObservers();
    } else if (command == "register again") {
        OSYSPRINT(("T registered %d\n", RegisterServiceEntry(OServiceEntry(myOID_, Entry_Control[0]), subjectService[0])));
    } else if (!FileCommand(command) && !NumberCommand(command) && !AperiosCommand(myOID_, command)) {
        OSYSPRINT(("T does not know '%s'\n", command.c_str()));
    }
}
