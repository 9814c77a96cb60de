// An object that does what texts tell it, with its subject and with the system, and prints what
// comes of it: the acting half of the conformance tests.
#ifndef Teller_h_DEFINED
#define Teller_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <string>

#include "def.h"

class Teller : public OObject {
public:
    Teller();

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void    ReadyOut(const OReadyEvent& event);
    void    ReadyLoop(const OReadyEvent& event);
    OStatus ControlLoop(const OControlEvent& event);
    OStatus ConnectLoop(const OConnectEvent& event);
    void    NotifyLoop(const ONotifyEvent& event);
    void    Command(void* msg);
    void    Tick(void* msg);
    void    Ask(void* msg);

private:
    void RunFile(const char* path);
    void Run(const std::string& command);

    RCRegion*          region;
    OMemoryStickStatus stick;  // at boot
    bool               fails;  // DoStart
};

// The rest of the commands; each prints its result.  False when the text is none of theirs.
bool FileCommand(const std::string& command);
bool NumberCommand(const std::string& command);
bool AperiosCommand(const OID& self, const std::string& command);

#endif  // Teller_h_DEFINED
