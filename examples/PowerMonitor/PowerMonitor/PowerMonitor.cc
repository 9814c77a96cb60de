#include "PowerMonitor.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/OSyslog.h>

#include "entry.h"

PowerMonitor::PowerMonitor() : isGoingDown_(false)
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

// Makes no subject and no observer, because nothing is connected.
OStatus
PowerMonitor::DoInit(const OSystemEvent&)
{
    return oSUCCESS;
}

// Asks for a message at every change of three bits, in both directions, and of the battery's
// capacity; changes of the other numbers cause no message.  Reads the present state first, because
// no message comes about it.
OStatus
PowerMonitor::DoStart(const OSystemEvent&)
{
    OPowerStatus status;
    if (OPENR::GetPowerStatus(&status) == oSUCCESS) Print(status);

    OPowerStatus wanted;
    wanted.Set(orsbPAUSE | orsbBATTERY_CAPACITY_LOW | orsbSTATION_CONNECTED, 0,
               opsoREMAINING_CAPACITY_NOTIFY_EVERY_CHANGE, opsoTEMPERATURE_NOT_NOTIFY,
               opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY);
    const OStatus result = OPENR::ObservePowerStatus(wanted, Entry());
    if (result == oSUCCESS) return oSUCCESS;
    OSYSLOG1((osyslogERROR, "PowerMonitor: cannot watch the power status, status %u",
              (unsigned)result));
    return oFAIL;
}

OStatus
PowerMonitor::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("PowerMonitor: good night\n"));
    return oSUCCESS;
}

OStatus
PowerMonitor::DoDestroy(const OSystemEvent&)
{
    return oSUCCESS;
}

// Returns the entry to which the messages are to be sent: this object and a selector in it.
OServiceEntry
PowerMonitor::Entry() const
{
    return OServiceEntry(myOID_, Extra_Entry[entryPowerChanged]);
}

void
PowerMonitor::PowerChanged(void* msg)
{
    const OPowerStatus& status = ((const OPowerStatusMessage*)msg)->powerStatus;
    if (isGoingDown_) return;
    if ((status.robotStatus & orsbPAUSE) != 0) {
        OSYSPRINT(("PowerMonitor: the pause button is pressed\n"));
        Shutdown();
    } else if ((status.robotStatus & orsbBATTERY_CAPACITY_LOW) != 0) {
        OSYSPRINT(("PowerMonitor: the battery is low\n"));
        Shutdown();
    } else {
        Print(status);
    }
}

void
PowerMonitor::Print(const OPowerStatus& status)
{
    OSYSPRINT(("PowerMonitor: battery %d %%, %d mV, %d mA, %.1f C%s\n",
               (int)status.remainingCapacity, (int)status.voltage, (int)status.current,
               status.temperature / 10.0 - 273.15,
               (status.robotStatus & orsbSTATION_CONNECTED) != 0 ? ", on its station" : ""));
}

// Shuts the robot down.  Shutdown() returns at once; then every object gets its DoStop, this one,
// too.
void
PowerMonitor::Shutdown()
{
    isGoingDown_ = true;
    OPENR::UnobservePowerStatus(Entry());
    OPENR::SetMotorPower(opowerOFF);
    const OStatus status = OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "PowerMonitor: shutdown failed, status %u", (unsigned)status));
    }
}
