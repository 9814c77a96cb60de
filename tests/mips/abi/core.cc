// Types and messages of the core.
#include <MCOOP.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>
#include <SystemTime.h>
#include <limits.h>

#include "abi.h"

// core 0.2, 7.3, robot 2
void CheckBasicTypes() {
  SIZE(int, 4);
  SIZE(long, 4);
  SIZE(void*, 4);
  SIZE(size_t, 4);
  SIZE(time_t, 4);
  SIZE(bool, 1);
  CheckNumber(__FILE__, __LINE__, "char is signed", CHAR_MIN < 0, 1);
  SIZE(byte, 1);
  SIZE(sbyte, 1);
  SIZE(word, 2);
  SIZE(sword, 2);
  SIZE(longword, 4);
  SIZE(slongword, 4);
  SIZE(int16, 2);
  SIZE(int32, 4);
  SIZE(int64, 4);
  SIZE(uint64, 4);
  SIZE(Selector, 4);
  SIZE(sError, 4);
  SIZE(OStatus, 4);
  SIZE(ODataType, 4);
  SIZE(OPrimitiveID, 4);
  SIZE(OVRSyncKey, 4);
  SIZE(OPower, 1);
  SIZE(MemoryRegionID, 4);
  SIZE(offset_t, 4);
  SIZE(OID, 4);
  SIZE(RID, 8);
  SIZE(EventID, 4);
  SIZE(RelativeTime, 8);
  SIZE(SystemTime, 8);
  const int one = 1;
  CheckNumber(__FILE__, __LINE__, "the low byte comes first",
              *reinterpret_cast<const unsigned char*>(&one), 1);
}

// core 1.3, 2.1, 2.9
void CheckCoreMessages() {
  SIZE(OServiceEntry, 8);
  SIZE(SubjectID, 8);
  SIZE(ObserverID, 8);

  SIZE(OReasonMessage, 140);
  AT(OReasonMessage, msgType, 0);
  AT(OReasonMessage, reason, 4);
  AT(OReasonMessage, paramSize, 8);
  AT(OReasonMessage, param, 12);

  SIZE(OControlMessage, 156);
  AT(OControlMessage, command, 4);
  AT(OControlMessage, observerID, 8);
  AT(OControlMessage, d_skip, 16);
  AT(OControlMessage, d_min, 20);
  AT(OControlMessage, d_max, 24);
  AT(OControlMessage, subName, 28);

  SIZE(OControlReplyMessage, 20);
  AT(OControlReplyMessage, status, 4);
  AT(OControlReplyMessage, subjectID, 8);
  AT(OControlReplyMessage, memID, 16);

  SIZE(OConnectMessage, 144);
  AT(OConnectMessage, command, 4);
  AT(OConnectMessage, entry, 8);
  AT(OConnectMessage, subName, 16);

  SIZE(OReadyMessage, 72);
  AT(OReadyMessage, msgType, 0);
  AT(OReadyMessage, command, 4);
  AT(OReadyMessage, observerID, 8);
  AT(OReadyMessage, numOfData, 16);
  AT(OReadyMessage, rcRegion, 20);

  SIZE(ONotifyMessage, 224);
  AT(ONotifyMessage, msgType, 0);
  AT(ONotifyMessage, subjectID, 4);
  AT(ONotifyMessage, numOfData, 12);
  AT(ONotifyMessage, numOfNotify, 14);
  AT(ONotifyMessage, data, 16);
  AT(ONotifyMessage, data[1], 32);
  AT(ONotifyMessage, data[0].memID, 20);
  AT(ONotifyMessage, data[0].offset, 24);
  AT(ONotifyMessage, data[0].size, 28);

  SIZE(OStatusMessage, 8);
  SIZE(OSyslogMessage, 256);  // core 1.6
  SIZE(OCPUInfo, 256);        // core 6.1
  AT(OCPUInfo, pclk, 4);
  AT(OCPUInfo, processorID, 8);
  AT(OCPUInfo, reserved, 12);
}

// core 6.3, robot 15
void CheckPower() {
  SIZE(OPowerStatus, 20);
  AT(OPowerStatus, robotStatus, 0);
  AT(OPowerStatus, batteryStatus, 4);
  AT(OPowerStatus, remainingCapacity, 6);
  AT(OPowerStatus, temperature, 8);
  AT(OPowerStatus, fullyChargedCapacity, 10);
  AT(OPowerStatus, voltage, 12);
  AT(OPowerStatus, current, 14);
  AT(OPowerStatus, timeDif, 16);
  AT(OPowerStatus, volume, 17);

  SIZE(OPowerStatusMessage, 24);
  AT(OPowerStatusMessage, powerStatus, 4);

  SIZE(OBootCondition, 16);
  AT(OBootCondition, bitmap, 0);
  AT(OBootCondition, bootTime, 4);
  AT(OBootCondition, bootTimeType, 8);
  AT(OBootCondition, vibrationLevel, 12);
}
