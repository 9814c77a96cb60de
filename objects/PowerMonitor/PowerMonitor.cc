#include "PowerMonitor.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/OSyslog.h>

#include "entry.h"

PowerMonitor::PowerMonitor()
{
    for (int i = 0; i < numOfSubject; i++) subject[i] = 0;
    for (int i = 0; i < numOfObserver; i++) observer[i] = 0;
}

OStatus
PowerMonitor::DoInit(const OSystemEvent&)
{
    return oSUCCESS;
}

// Begins to observe all bits of the power status.  Does not observe its numbers, because capacity
// and temperature change often and have no effect here.
OStatus
PowerMonitor::DoStart(const OSystemEvent&)
{
    OPowerStatus now;
    if (OPENR::GetPowerStatus(&now) == oSUCCESS) PrintPowerStatus(now);

    OPowerStatus notify;
    notify.Set(orsbALL, obsbALL, opsoREMAINING_CAPACITY_NOT_NOTIFY, opsoTEMPERATURE_NOT_NOTIFY,
               opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY);
    const OServiceEntry entry(myOID_, Extra_Entry[entryUpdatePowerStatus]);
    const OStatus status = OPENR::ObservePowerStatus(notify, entry);
    if (status == oSUCCESS) return oSUCCESS;
    OSYSLOG1(
        (osyslogERROR, "PowerMonitor: cannot watch the power status, status %u", (unsigned)status));
    return oFAIL;
}

OStatus
PowerMonitor::DoStop(const OSystemEvent&)
{
    return oSUCCESS;
}

OStatus
PowerMonitor::DoDestroy(const OSystemEvent&)
{
    return oSUCCESS;
}

void
PowerMonitor::UpdatePowerStatus(void* msg)
{
    const OPowerStatus& status = ((const OPowerStatusMessage*)msg)->powerStatus;
    if ((status.robotStatus & (orsbPAUSE | orsbBATTERY_CAPACITY_LOW)) == 0) return;
    PrintPowerStatus(status);
    ShutdownRobot();
}

// Shuts the robot down.  Continues when a step fails, because the robot must be switched off even
// then.
void
PowerMonitor::ShutdownRobot()
{
    const OServiceEntry entry(myOID_, Extra_Entry[entryUpdatePowerStatus]);
    // Ends the observation first, because SetMotorPower(opowerOFF) changes the power
    // status, too, and the message of this change would shut the robot down a second time.
    OStatus status = OPENR::UnobservePowerStatus(entry);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "PowerMonitor: cannot stop watching power, status %u",
                  (unsigned)status));
    }
    status = OPENR::SetMotorPower(opowerOFF);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "PowerMonitor: cannot switch motor power off, status %u",
                  (unsigned)status));
    }
    // The boot condition makes the robot boot when the pause button is pressed again.
    status = OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "PowerMonitor: shutdown failed, status %u", (unsigned)status));
    }
}

void
PowerMonitor::PrintPowerStatus(const OPowerStatus& status)
{
    OSYSDEBUG(("PowerMonitor: robot %08x battery %04x capacity %d %% temperature %d x 0.1 K\n",
               (unsigned)status.robotStatus, (unsigned)status.batteryStatus,
               (int)status.remainingCapacity, (int)status.temperature));
    (void)status;  // avoids a warning: `status` is unused where OSYSDEBUG is empty
}
