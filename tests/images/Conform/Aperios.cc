// The calls of MCOOP.h and the system's part of OPENR::, one command each.
#include <MCOOP.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <string.h>

#include "Teller.h"

static OID
FindObject(const char* name)
{
    OID oid;
    Find(name, &oid);
    return oid;
}

static Selector
EntryOf(const char* name)
{
    Selector selector = UNDEF;
    FindSelector(name, &selector);
    return selector;
}

static EventID lastEvent;
static RID     lastBox;

static void
Timer(const OID& self, int first, int period)
{
    TimeEventInfoWithRelativeTime info(RelativeTime(0, first), RelativeTime(0, period));
    char text[] = "tock";
    const sError error = SetTimeEvent(&info, self, EntryOf("Tick"), text, sizeof text, &lastEvent);
    OSYSPRINT(("T timer %d id %d\n", error, lastEvent.value != EventID_UNDEF));
}

static void
Memory(const OID& self)
{
    MemoryRegionID id;
    void* base = 0;
    unsigned int page = 0;  // both are size_t on the robot
    size_t left = 0;
    GetPageSize(&page);
    GetFreeMemorySize(&left);
    const sError made = NewSharedMemoryRegion(5000, MEMPROTINFO_RW, &id, &base);
    void* again = 0;
    const sError attached = AttachMemoryRegion(id, MEMPROTINFO_R, &again);
    const bool same = again == base;
    const sError twice = AttachMemoryRegion(id, MEMPROTINFO_R, &again);
    const sError allowed = AllowToAttachMemoryRegion(id, MEMPROTINFO_R, self, false);
    const sError shrunk = ShrinkMemoryRegion(id, 100);
    const sError grown = GrowMemoryRegion(id, 5000);
    const sError too_far = GrowMemoryRegion(id, 9000);
    const sError detached = DetachMemoryRegion(id);
    const sError deleted = DeleteSharedMemoryRegion(id);
    const sError unknown = AttachMemoryRegion(id, MEMPROTINFO_R, &again);
    OSYSPRINT(("T page %d free %d made %d same %d %d %d allow %d size %d %d %d detach %d delete %d unknown %d\n",
               (int)page, left > 1000000, made, same, attached, twice, allowed, shrunk, grown, too_far, detached,
               deleted, unknown));
    void* mine = 0;
    const sError new_region = NewRegion(10000, &mine);
    memset(mine, 1, 10000);
    const sError delete_region = DeleteRegion(mine);
    OSYSPRINT(("T private %d %d %d\n", new_region, delete_region, DeleteRegion(mine)));
}

static void
Resources()
{
    slongword queue = 0, max = 0, min = 0, entries = 0, size = 0, events = 0;
    GetResourceValue(rMAXQUEUESIZE, &queue, &max, &min);
    GetResourceValue(rMAXENTRIES, &entries);
    GetResourceValue(rMAXMESSAGESIZE, &size);
    GetResourceValue(rMAXEVENT, &events);
    const sError set = SetResourceValue(rMAXQUEUESIZE, 40);
    GetResourceValue(rMAXQUEUESIZE, &max);
    OSYSPRINT(("T queue %d entries %d message %d events %d set %d now %d bad %d\n", queue, entries, size, events > 0, set,
               max, GetResourceValue(99, &max)));
}

static void
Names(const OID& self)
{
    OID me, other;
    const sError who = WhoAmI(&me);
    char long_name[80];
    memset(long_name, 'x', sizeof long_name);
    long_name[79] = 0;
    const sError before = Find("alias", &other);
    const sError made = Register(self, "alias");
    const sError found = Find("alias", &other);
    const bool same = other == self;
    const sError again = Register(self, "alias");
    const sError too_long = Register(self, long_name);
    const sError gone = Unregister("alias");
    OSYSPRINT(("T who %d %d find %d register %d find %d %d again %d long %d unregister %d find %d\n", who, me == self,
               before, made, found, same, again, too_long, gone, Find("alias", &other)));
}

static void
Ask(const char* text, int timeout_ms)
{
    char reply[32] = "";
    unsigned int got = 0;
    RelativeTime timeout(0, timeout_ms);
    const sError sent = SendWithRBox(FindObject("nobody"), 4, 0, 0, &lastBox);
    OSYSPRINT(("T unknown object %d\n", sent));
    const sError error =
        Send(FindObject("asked"), 4, const_cast<char*>(text), strlen(text) + 1, &lastBox);
    const sError received = Receive(lastBox, reply, sizeof reply, &got, &timeout);
    const sError twice = received == sSUCCESS ? Receive(lastBox) : 0;
    const sError cleaned = CleanRBox(lastBox);
    OSYSPRINT(("T send %d receive %d '%s' %d twice %d clean %d\n", error, received, reply, (int)got, twice, cleaned));
}

// The reply is received in Tick's stead, without waiting.
static void
AskLater(const OID& self)
{
    char question[] = "answer";
    char text[] = "can be received";
    SendWithRBox(FindObject("asked"), 4, question, sizeof question, &lastBox);
    OSYSPRINT(("T reply event %d\n", SetReplyEvent(lastBox, self, EntryOf("Tick"), text, sizeof text, &lastEvent)));
}

static void
ReceiveNow()
{
    char reply[32] = "";
    RelativeTime none;
    const sError error = Receive(lastBox, reply, sizeof reply, &none);
    OSYSPRINT(("T received %d '%s'\n", error, reply));
}

static void
Status()
{
    OMemoryStickStatus stick = omemorystickUNDEF;
    char design[orobotdesignNAME_MAX + 1] = "";
    OPENR::GetMemoryStickStatus(&stick);
    OPENR::GetRobotDesign(design);
    OSYSPRINT(("T stick %d design %s\n", (int)stick, design));
}

static void
Design(const char* keyword)
{
    ODesignDataID id = odesigndataID_UNDEF, second = odesigndataID_UNDEF;
    byte* data = 0;
    byte* other = 0;
    unsigned int size = 0;
    const OStatus found = OPENR::FindDesignData(keyword, &id, &data, &size);
    OSYSPRINT(("T design %d size %d", found, (int)size));
    if (found == oSUCCESS) {
        OPENR::FindDesignData(keyword, &second, &other, &size);
        OSYSPRINT((" '%.5s' copies %d %d", (const char*)data, id != second, data != other));
        OSYSPRINT((" delete %d", OPENR::DeleteDesignData(id)));
        OSYSPRINT((" %d", OPENR::DeleteDesignData(second)));
        OSYSPRINT((" %d", OPENR::DeleteDesignData(id)));
    }
    OSYSPRINT(("\n"));
}

static void
Logs()
{
    char text[600];
    memset(text, 'a', sizeof text);
    text[599] = 0;
    OSYSPRINT(("%s", text));
    OSYSPRINT(("|\n"));
    OSYSLOG1((osyslogERROR, "%s", text));
    OSYSLOG1((osyslogWARNING, "This is %s!", "a warning"));
    OSYSLOG2((osyslogWARNING, "not compiled in"));
    OSYSDEBUG(("not compiled in\n"));
}

bool
AperiosCommand(const OID& self, const std::string& command)
{
    int first = 0, period = 0, selector = 0;
    char word[40] = "";
    if (sscanf(command.c_str(), "timer %d %d", &first, &period) == 2) {
        Timer(self, first, period);
    } else if (command == "cancel") {
        const sError error = CancelEvent(lastEvent);
        OSYSPRINT(("T cancel %d again %d\n", error, CancelEvent(lastEvent)));
    } else if (command == "memory") {
        Memory(self);
    } else if (command == "resources") {
        Resources();
    } else if (command == "names") {
        Names(self);
    } else if (sscanf(command.c_str(), "ask %39s %d", word, &period) == 2) {
        Ask(word, period);
    } else if (sscanf(command.c_str(), "post %d", &selector) == 1) {
        char text[300] = "posted";
        OSYSPRINT(("T post %d\n", Send(FindObject("hearer"), selector, text, 7)));
    } else if (command == "post too much") {
        char text[300] = "";
        OSYSPRINT(("T post %d\n", Send(self, EntryOf("Tick"), text, 257)));
    } else if (command == "ask later") {
        AskLater(self);
    } else if (command == "receive") {
        ReceiveNow();
    } else if (command == "status") {
        Status();
    } else if (sscanf(command.c_str(), "design %39s", word) == 1) {
        Design(word);
    } else if (command == "log") {
        Logs();
    } else {
        return false;
    }
    return true;
}
