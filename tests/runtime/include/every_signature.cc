// Every function of the core with its signature, checked by the compiler only: what core.md
// and network.md list can be called as they list it.  gnu++98 and later.
#include <DNSEndpointMsg.h>
#include <ERA201D1.h>
#include <EndpointTypes.h>
#include <IPEndpointMsg.h>
#include <MCOOP.h>
#include <OPENR/ArrayStack.h>
#include <OPENR/OCalendarTime.h>
#include <OPENR/OList.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OObserverVector.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OPENRServices.h>
#include <OPENR/OPair.h>
#include <OPENR/OQueue.h>
#include <OPENR/OSubject.h>
#include <OPENR/OTime.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>

// Checks the type of a member or function; its value is never used.
#define MEMBER(result, type, name, parameters)       \
  {                                                  \
    result(type::*pointer) parameters = &type::name; \
    (void)pointer;                                   \
  }
#define FUNCTION(result, name, parameters) \
  {                                        \
    result(*pointer) parameters = &name;   \
    (void)pointer;                         \
  }

// core.md 1.2, 1.4
class Core : public OObject {
 public:
  void Check() {
    MEMBER(void, OObject, Init, (const OSystemEvent&))
    MEMBER(void, OObject, Start, (const OSystemEvent&))
    MEMBER(void, OObject, Stop, (const OSystemEvent&))
    MEMBER(void, OObject, Destroy, (const OSystemEvent&))
    MEMBER(OStatus, OObject, DoInit, (const OSystemEvent&))
    MEMBER(OStatus, OObject, DoStart, (const OSystemEvent&))
    MEMBER(OStatus, OObject, DoStop, (const OSystemEvent&))
    MEMBER(OStatus, OObject, DoDestroy, (const OSystemEvent&))
    OStatus (Core::*service)(const OServiceEntry&, const char*) = &Core::RegisterServiceEntry;
    (void)service;
    OID oid = myOID_;
    (void)oid;
    MEMBER(OReason, OSystemEvent, Reason, () const)
    MEMBER(const void*, OSystemEvent, Param, () const)
    MEMBER(size_t, OSystemEvent, ParamSize, () const)
  }
};

// core.md 2.1, 2.2
void CheckSubject() {
  MEMBER(void, OServiceEntry, Set, (const OID&, Selector))
  MEMBER(OID, OServiceEntry, GetOID, () const)
  MEMBER(Selector, OServiceEntry, GetSelector, () const)
  MEMBER(bool, OServiceEntry, IsValid, () const)
  MEMBER(void, OServiceEntry, MakeInvalid, ())
  MEMBER(OStatus, OSubject, SetReadyEntry, (const OServiceEntry&))
  MEMBER(const SubjectID&, OSubject, GetID, () const)
  MEMBER(OStatus, OSubject, SetBufferSize, (size_t))
  MEMBER(size_t, OSubject, GetBufferSize, () const)
  MEMBER(OStatus, OSubject, SetNotifyUnitSize, (size_t))
  MEMBER(size_t, OSubject, GetNotifyUnitSize, () const)
  MEMBER(OStatus, OSubject, SetData, (const void*, size_t))
  MEMBER(OStatus, OSubject, SetData, (RCRegion*))
  MEMBER(OStatus, OSubject, SetData, (const OShmPtrBase&))
  MEMBER(OStatus, OSubject, SetData, (const OObserverInfo&, const void*, size_t))
  MEMBER(OStatus, OSubject, SetData, (const OObserverInfo&, RCRegion*))
  MEMBER(OStatus, OSubject, SetData, (const OObserverInfo&, const OShmPtrBase&))
  MEMBER(OStatus, OSubject, SetData, (const ObserverID&, const void*, size_t))
  MEMBER(OStatus, OSubject, SetData, (const ObserverID&, RCRegion*))
  MEMBER(OStatus, OSubject, SetData, (const ObserverID&, const OShmPtrBase&))
  MEMBER(OStatus, OSubject, SetData, (MemoryRegionID, size_t))
  MEMBER(OStatus, OSubject, SetData, (const OMemoryLocator&))
  MEMBER(OStatus, OSubject, SetData, (const ObserverID&, MemoryRegionID, u_int))
  MEMBER(OStatus, OSubject, SetData, (const ObserverID&, const OMemoryLocator&))
  MEMBER(OStatus, OSubject, NotifyObservers, ())
  MEMBER(OStatus, OSubject, NotifyObserver, (const OObserverInfo&))
  MEMBER(OStatus, OSubject, NotifyObserver, (const ObserverID&))
  MEMBER(size_t, OSubject, RemainBuffer, () const)
  MEMBER(size_t, OSubject, RemainBuffer, (const OObserverInfo&) const)
  MEMBER(size_t, OSubject, RemainBuffer, (const ObserverID&) const)
  MEMBER(OStatus, OSubject, ClearBuffer, ())
  MEMBER(OStatus, OSubject, ClearBuffer, (const OObserverInfo&))
  MEMBER(OStatus, OSubject, ClearBuffer, (const ObserverID&))
  MEMBER(OStatus, OSubject, ControlHandler, (const OControlMessage&, OStatus))
  MEMBER(OStatus, OSubject, ControlHandler, (const OControlMessage*, OStatus))
  MEMBER(OStatus, OSubject, ReadyHandler, (const OReadyMessage&))
  MEMBER(OStatus, OSubject, ReadyHandler, (const OReadyMessage*))
  MEMBER(int, OSubject, NumberOfObservers, () const)
  MEMBER(ObserverConstIterator, OSubject, begin, () const)
  MEMBER(ObserverConstIterator, OSubject, end, () const)
  MEMBER(ObserverConstIterator, OSubject, FindObserver, (const ObserverID&) const)
  MEMBER(int, OSubject, IsAllReady, () const)
  MEMBER(int, OSubject, IsAnyReady, () const)
  MEMBER(int, OSubject, IsReady, () const)
  MEMBER(int, OSubject, IsReady, (const ObserverID&) const)
  MEMBER(int, OSubject, IsReady, (const OObserverInfo&) const)
  MEMBER(int, OSubject, ReadyStatus, (const ObserverID&) const)
  MEMBER(int, OSubject, ReadyStatus, (const OObserverInfo&) const)
  MEMBER(const ObserverID&, OObserverInfo, GetObserverID, () const)
}

// core.md 2.3, 2.4
void CheckObserver() {
  MEMBER(OStatus, OObserver, SetNotifyEntry, (const OServiceEntry&))
  MEMBER(void, OObserver, SetSkip, (size_t))
  MEMBER(void, OObserver, SetBufCtrlParam, (size_t, size_t, size_t))
  MEMBER(OStatus, OObserver, AssertReady, ())
  MEMBER(OStatus, OObserver, AssertReady, (const SubjectID&))
  MEMBER(OStatus, OObserver, AssertReady, (const OSubjectInfo&))
  MEMBER(OStatus, OObserver, DeassertReady, ())
  MEMBER(OStatus, OObserver, DeassertReady, (const SubjectID&))
  MEMBER(OStatus, OObserver, DeassertReady, (const OSubjectInfo&))
  MEMBER(SubjectConstIterator, OObserver, begin, () const)
  MEMBER(SubjectConstIterator, OObserver, end, () const)
  MEMBER(int, OObserver, NumberOfSubjects, () const)
  MEMBER(const ObserverID&, OObserver, GetID, () const)
  MEMBER(const ObserverID&, OObserver, GetObserverID, () const)
  MEMBER(SubjectID, OObserver, FindSender, (RCRegion*) const)
  MEMBER(OStatus, OObserver, ConnectHandler, (const OConnectMessage&, OStatus))
  MEMBER(OStatus, OObserver, ConnectHandler, (const OConnectMessage*, OStatus))
  MEMBER(OStatus, OObserver, NotifyHandler, (const ONotifyMessage&, ONotifyEvent*))
  MEMBER(OStatus, OObserver, NotifyHandler, (const ONotifyMessage*, ONotifyEvent*))
  MEMBER(const SubjectID&, OSubjectInfo, GetSubjectID, () const)
  MEMBER(ObjcommVersion, OSubjectInfo, GetVersion, () const)
  MEMBER(int, ONotifyEvent, ObsIndex, () const)
  MEMBER(const OSubjectInfo&, ONotifyEvent, SenderID, () const)
  MEMBER(int, ONotifyEvent, NumOfData, () const)
  MEMBER(int, ONotifyEvent, NumOfNotify, () const)
  MEMBER(const void*, ONotifyEvent, Data, (int) const)
  MEMBER(const void**, ONotifyEvent, Data, () const)
  MEMBER(RCRegion*, ONotifyEvent, RCData, (int) const)
  MEMBER(void, ONotifyEvent, SetIndex, (int))
  MEMBER(void, ONotifyEvent, SetSubjectInfo, (const OSubjectInfo&))
  MEMBER(void, ONotifyEvent, SetNumOfData, (int))
  MEMBER(void, ONotifyEvent, SetNumOfNotify, (int))
  MEMBER(void, ONotifyEvent, SetData, (int, RCRegion*))
  MEMBER(int, OReadyEvent, SbjIndex, () const)
  MEMBER(const ObserverID&, OReadyEvent, SenderID, () const)
  MEMBER(bool, OReadyEvent, IsAssert, () const)
  MEMBER(bool, OReadyEvent, IsDeassert, () const)
  MEMBER(int, OControlEvent, SbjIndex, () const)
  MEMBER(const char*, OControlEvent, SubName, () const)
  MEMBER(bool, OControlEvent, IsAddObserver, () const)
  MEMBER(bool, OControlEvent, IsRemoveObserver, () const)
  MEMBER(const ObserverID&, OControlEvent, SenderID, () const)
  MEMBER(int, OConnectEvent, ObsIndex, () const)
  MEMBER(const char*, OConnectEvent, SubName, () const)
  MEMBER(bool, OConnectEvent, IsConnect, () const)
  MEMBER(bool, OConnectEvent, IsDisconnect, () const)
  OObserverVector* vector = 0;
  (void)vector;
}

// core.md 2.8
void CheckRegion() {
  MEMBER(void, RCRegion, AddReference, ())
  MEMBER(void, RCRegion, RemoveReference, ())
  MEMBER(int, RCRegion, NumberOfReference, () const)
  MEMBER(char*, RCRegion, Base, () const)
  MEMBER(size_t, RCRegion, Size, () const)
  MEMBER(MemoryRegionID, RCRegion, MemID, () const)
  MEMBER(offset_t, RCRegion, Offset, () const)
  MEMBER(void, RCRegion, SetSize, (size_t))
  MEMBER(RCRegion::RegionType, RCRegion, GetType, () const)
  RCRegionBase* old_name = new RCRegion;
  (void)old_name;
  RCRegion::RegionType types[] = {RCRegion::SELF_ALLOCATED, RCRegion::REFERENCE_V20,
                                  RCRegion::REFERENCE_V10, RCRegion::UNDEF};
  (void)types;
  MEMBER(void, OShmPtrBase, Deallocate, ())
  MEMBER(char*, OShmPtrBase, BaseAddress, () const)
  MEMBER(char*, OShmPtrBase, Base, () const)
  MEMBER(size_t, OShmPtrBase, Size, () const)
  MEMBER(RCRegion*, OShmPtrBase, RCRPtr, () const)
  MEMBER(MemoryRegionID, OShmPtrBase, MemID, () const)
  MEMBER(unsigned, OShmPtrBase, Offset, () const)
  MEMBER(int, OShmPtr<int>, NumOfElement, () const)
  MEMBER(void, OShmPtr<int>, Copy, (const void*, size_t))
  MEMBER(void, OShmPtr<int>, Allocate, (int))
  MEMBER(void, OShmPtr<int>, AllocateCopy, (size_t, void*))
  OShmPtr<int> pointer(size_t(4));
  const OShmPtr<int>& constant = pointer;
  pointer[1] = constant[0];
  *pointer = *constant + pointer.Size();
  int copy[4];
  memcpy(copy, pointer, sizeof copy);
  memcpy(pointer, copy, sizeof copy);
}

// core.md 3.2, 6.1: functions about devices are in robot.md.
void CheckSystemApi() {
  FUNCTION(OStatus, OPENR::SetMotorPower, (OPower))
  FUNCTION(OStatus, OPENR::Shutdown, (const OBootCondition&))
  FUNCTION(OStatus, OPENR::GetBootCondition, (OBootCondition*))
  FUNCTION(OStatus, OPENR::GetPowerStatus, (OPowerStatus*))
  FUNCTION(OStatus, OPENR::ObservePowerStatus, (const OPowerStatus&, const OServiceEntry&))
  FUNCTION(OStatus, OPENR::UnobservePowerStatus, (const OServiceEntry&))
  FUNCTION(OStatus, OPENR::FindDesignData, (const char*, ODesignDataID*, byte**, size_t*))
  ODesignDataID data;
  byte* address;
  size_t size;
  unsigned int narrow_size;  // the same type on the robot
  OPENR::FindDesignData("KEYWORD", &data, &address, &size);
  OPENR::FindDesignData("KEYWORD", &data, &address, &narrow_size);
  OPENR::FindDesignData("KEYWORD", &data, &address, 0);
  FUNCTION(OStatus, OPENR::DeleteDesignData, (ODesignDataID))
  FUNCTION(OStatus, OPENR::GetRobotDesign, (char*))
  FUNCTION(OStatus, OPENR::GetMemoryStickStatus, (OMemoryStickStatus*))
  FUNCTION(OStatus, OPENR::Fatal, (OFatal))
  FUNCTION(OStatus, OPENR::SetTime, (const OTime&))
  FUNCTION(OStatus, OPENR::GetTime, (OTime*))
  FUNCTION(OStatus, OPENR::SetTimeDifference, (sbyte))
  FUNCTION(OStatus, OPENR::GetTimeDifference, (sbyte*))
  FUNCTION(OStatus, OPENR::SetVolumeSwitch, (OVolumeSwitch))
  FUNCTION(OStatus, OPENR::GetVolumeSwitch, (OVolumeSwitch*))
  FUNCTION(OStatus, OPENR::RequireMWInfo, (MWIID))
  FUNCTION(OStatus, OPENR::CancelMWInfo, (MWIID))
  FUNCTION(OStatus, OPENR::IsMWInfoRequired, (MWIID, bool*))
  FUNCTION(OStatus, osyslog, (OSyslogPriority, const char*, ...))
  FUNCTION(OStatus, osysprint, (const char*, ...))
  int number = -OSYSPRINT(("an expression"));  // its type must be arithmetic (core.md 3.2)
  if (number) OSYSDEBUG(("may vanish"));
  if (number) OSYSLOG4((osyslogINFO, "may vanish"));
}

// core.md 6.4
void CheckTime() {
  MEMBER(OStatus, OTime, Set, (time_t, sbyte))
  MEMBER(OStatus, OTime, SetClock, (time_t))
  MEMBER(OStatus, OTime, SetLocalTime, (time_t))
  MEMBER(OStatus, OTime, SetTimeDif, (sbyte))
  MEMBER(time_t, OTime, GetClock, () const)
  MEMBER(time_t, OTime, GetLocalTime, () const)
  MEMBER(sbyte, OTime, GetTimeDif, () const)
  MEMBER(OStatus, OCalendarTime, SetTime, (time_t, sbyte))
  MEMBER(OStatus, OCalendarTime, SetTime, (const OTime&))
  MEMBER(OStatus, OCalendarTime, GetTime, (time_t*, sbyte*) const)
  MEMBER(OStatus, OCalendarTime, GetTime, (OTime*) const)
  MEMBER(bool, OCalendarTime, ProperDate, () const)
  MEMBER(OStatus, OCalendarTime, CorrectDayOfTheWeek, ())
  MEMBER(void, OCalendarTime, Print, () const)
  MEMBER(void, OCalendarTime, Sprint, (char*) const)
  MEMBER(void, OCalendarTime, RFC2822, (char*) const)
  FUNCTION(bool, LeapYear, (int))
  MEMBER(bool, SystemTime, IsValid, () const)
  MEMBER(void, SystemTime, MakeInvalid, ())
  RelativeTime spans[] = {RelativeTime(), RelativeTime(1), RelativeTime(1, 500)};
  (void)(spans[0] == spans[1]);
  MEMBER(void, TimeEventInfoWithRelativeTime, Set, (RelativeTime, RelativeTime, longword))
  MEMBER(void, TimeEventInfoWithRelativeTime, Set, (TimeEventInfo::EventType, RelativeTime))
}

// core.md 6.5
void CheckAperios() {
  FUNCTION(sError, GetSystemTime, (SystemTime*))
  FUNCTION(sError, WhoAmI, (OID*))
  FUNCTION(sError, Register, (OID, const char*))
  FUNCTION(sError, Unregister, (const char*))
  FUNCTION(sError, FindSelector, (const char*, Selector*))
  FUNCTION(sError, SendWithRBox, (OID, Selector, void*, size_t, RID*))
  FUNCTION(sError, Call, (OID, Selector, void*, size_t, void*, size_t))
  FUNCTION(sError, Reply, (void*, size_t))
  FUNCTION(sError, CleanRBox, (RID))
  FUNCTION(void, Return, (void*, size_t))
  FUNCTION(void, Exit, ())
  FUNCTION(void, ExitFromPrologue, ())
  FUNCTION(sError, SetTimeEvent, (TimeEventInfo*, OID, Selector, void*, size_t, EventID*))
  FUNCTION(sError, SetReplyEvent, (RID, OID, Selector, void*, size_t, EventID*))
  FUNCTION(sError, CancelEvent, (EventID))
  FUNCTION(sError, NewRegion, (size_t, void**))
  FUNCTION(sError, DeleteRegion, (void*))
  FUNCTION(sError, NewSharedMemoryRegion, (size_t, MemoryProtectionInfo, MemoryRegionID*, void**))
  FUNCTION(sError, DeleteSharedMemoryRegion, (MemoryRegionID))
  FUNCTION(sError, AllowToAttachMemoryRegion, (MemoryRegionID, MemoryProtectionInfo, OID, bool))
  FUNCTION(sError, AttachMemoryRegion, (MemoryRegionID, MemoryProtectionInfo, void**))
  FUNCTION(sError, DetachMemoryRegion, (MemoryRegionID))
  FUNCTION(sError, ChangeProtectionMemoryRegion, (MemoryRegionID, MemoryProtectionInfo))
  FUNCTION(sError, GrowMemoryRegion, (MemoryRegionID, size_t))
  FUNCTION(sError, ShrinkMemoryRegion, (MemoryRegionID, size_t))
  FUNCTION(sError, GetPageSize, (size_t*))
  FUNCTION(sError, GetFreeMemorySize, (size_t*))
  FUNCTION(sError, SetResourceValue, (sResource, slongword))
  FUNCTION(sError, GetResourceValue, (sResource, slongword*, slongword*, slongword*))
  FUNCTION(sError, Wait, (longword))
  OID oid;
  Selector selector;
  RID rbox;
  RelativeTime second(1);
  char name[] = "object";  // old sources have no const
  size_t got;
  Find(name, &oid);
  Find(name, &selector);
  Send(oid, selector, name, sizeof name);
  Send(oid, selector, name, sizeof name, &rbox);
  Receive(rbox);
  Receive(rbox, name, sizeof name, &got, &second);
  Receive(rbox, name, sizeof name, &second);
  Receive(rbox, name, sizeof name, 0, &second);
  Receive(rbox, name, sizeof name, NULL, &second);
  unsigned int narrow;  // the same type on the robot
  Receive(rbox, name, sizeof name, &narrow);
  Receive(rbox, name, sizeof name, &narrow, &second);
  GetPageSize(&narrow);
  GetFreeMemorySize(&narrow);
  MEMBER(OID, TID, GetMailer, () const)
  MEMBER(longword, TID, GetValue, () const)
  MEMBER(void*, OID, GetAddress, () const)
}

// core.md 6.6
void CheckContainers() {
  typedef OList<int, 4> List;
  MEMBER(OTLStatus, List, PushFront, (const int&))
  MEMBER(OTLStatus, List, PushBack, (const int&))
  MEMBER(OTLStatus, List, PopFront, ())
  MEMBER(OTLStatus, List, PopBack, ())
  MEMBER(int&, List, Front, ())
  MEMBER(int&, List, Back, ())
  MEMBER(void, List, Clear, ())
  MEMBER(OTLStatus, List, Insert, (List::Iterator, const int&))
  MEMBER(OTLStatus, List, Erase, (List::Iterator))
  typedef ODeque<int, 4> Deque;
  MEMBER(OTLStatus, Deque, PushFront, (const int&))
  MEMBER(OTLStatus, Deque, PopBack, ())
  MEMBER(int&, Deque, Back, ())
  typedef OQueue<int, 4> Queue;
  MEMBER(OTLStatus, Queue, PushBack, (const int&))
  MEMBER(OTLStatus, Queue, PopFront, ())
  MEMBER(int&, Queue, Front, ())
  OPair<int, char> pair;
  pair.first = pair.second = 0;
}

// network.md
void CheckNetwork() {
  MEMBER(antError, antEnvMsg, Send, (antStackRef, OID&, int32, int))
  MEMBER(antError, antEnvMsg, Call, (antStackRef, int))
  FUNCTION(antEnvMsg*, antEnvMsg::Receive, (ANTENVMSG))
  MEMBER(int32, antEnvMsg, GetOperation, () const)
  MEMBER(antError, antSharedBuffer, Map, ())
  MEMBER(antError, antSharedBuffer, UnMap, ())
  MEMBER(void*, antSharedBuffer, GetAddress, ())
  MEMBER(uint32, antSharedBuffer, GetSize, () const)
  FUNCTION(EtherStatus, ERA201D1_GetMACAddress, (EtherDriverGetMACAddressMsg*))
  FUNCTION(EtherStatus, ERA201D1_GetEtherStatistics, (EtherDriverGetStatisticsMsg*))
  FUNCTION(EtherStatus, ERA201D1_GetWLANSettings, (EtherDriverGetWLANSettingsMsg*))
  FUNCTION(EtherStatus, ERA201D1_GetWLANStatistics, (EtherDriverGetWLANStatisticsMsg*))
  antModuleRef module;
  byte data[8];
  IPAddress address(10, 0, 1, 2);
  antEnvCreateEndpointMsg create(EndpointType_TCP);
  TCPEndpointSetBlockingModeMsg blocking(module, true);
  TCPEndpointReadyForReadMsg ready(module);
  TCPEndpointAcceptMsg accept(module);
  TCPEndpointBacklogQueueMsg backlog(module, 4);
  TCPEndpointCloseMsg close(module, false, 0, true);
  UDPEndpointSendMsg send(module, data, 8);
  UDPEndpointSendMsg send_to(module, address, 9, data, 8);
  UDPEndpointResetConnectMsg reset(module);
  DNSEndpointSetServerAddressesMsg servers(module, 1, &address);
  DNSEndpointGetHostByAddrMsg by_address(module, address);
  DNSEndpointGetAliasMsg alias(module, 0);
  IPEndpointSendMsg raw(module, IP_DATA, data, 8);
  antEnvInitGetParamMsg get("ETHER_IP");
  antEnvInitSetParamMsg set("key", 1);
  antEnvInitSetParamMsg set_text("key", "value");
  antEnvInitStartMsg start;
  antEnvDestroySharedBufferMsg destroy(*new antSharedBuffer);
}
