// Names, limits and ids that all parts of OPEN-R share.
#ifndef OPENR_OPENR_H_INCLUDED
#define OPENR_OPENR_H_INCLUDED

#include <MemoryRegion.h>
#include <OID.h>
#include <OPENR/CLibrary.h>
#include <OPENR/OPrimitiveTypes.h>
#include <OPENR/OStatus.h>
#include <Types.h>

// ---- entries of an object

// The selectors that every object has.  The stub numbers all other entries from oentryBASE on, in
// this order: control of each subject, ready of each subject, connect of each observer, notify of
// each observer, and the entries of the lines "Extra" of stub.cfg.
const Selector oentryINIT = 0;
const Selector oentrySTART = 1;
const Selector oentrySTOP = 2;
const Selector oentryDESTROY = 3;
const Selector oentryBASE = 4;

// An entry of an object, to which messages are sent: the object and a selector.  The id of a
// subject is its Ready entry.  The id of an observer is its Notify entry.
struct OServiceEntry {
  OID oid;
  Selector selector;

  OServiceEntry() : selector(UNDEF) {}  // makes an invalid entry
  OServiceEntry(const OID& o, Selector s) : oid(o), selector(s) {}

  void Set(const OID& o, Selector s) {
    oid = o;
    selector = s;
  }
  OID GetOID() const { return oid; }
  Selector GetSelector() const { return selector; }

  // Returns whether both the object and the selector of this entry are set.
  bool IsValid() const { return oid.IsValid() && selector != UNDEF; }
  void MakeInvalid() {
    oid.MakeInvalid();
    selector = UNDEF;
  }

  friend bool operator==(const OServiceEntry& left, const OServiceEntry& right) {
    return left.oid == right.oid && left.selector == right.selector;
  }
  friend bool operator!=(const OServiceEntry& left, const OServiceEntry& right) {
    return !(left == right);
  }
  // Compares two entries, by object and then by selector.
  friend bool operator<(const OServiceEntry& left, const OServiceEntry& right) {
    if (left.oid != right.oid) return left.oid < right.oid;
    return left.selector < right.selector;
  }
};

// The commands that the object manager sends to an observer in an OConnectMessage: connect to a
// subject, or disconnect.
typedef longword OConnectCmd;
const OConnectCmd oconnectcmdCONNECT = 0;
const OConnectCmd oconnectcmdDISCONNECT = 1;
const OConnectCmd oconnectcmdDISCONNECTALL = 2;

// ---- reasons of calls of DoInit, DoStart, DoStop and DoDestroy

typedef longword OReason;
const OReason oreasonUNDEF = 0xffffffff;
const OReason oreasonBOOT = 0;
const OReason oreasonSHUTDOWN = 1;
const size_t oreasonPARAM_MAX_SIZE = 128;  // size in bytes of OReasonMessage::param

typedef longword OMemoryStickStatus;
const OMemoryStickStatus omemorystickUNDEF = 0xffffffff;
const OMemoryStickStatus omemorystickNOT_EXIST = 0;
const OMemoryStickStatus omemorystickWRITE_PROTECTED = 1;
const OMemoryStickStatus omemorystickWRITABLE = 2;

// The parameters of DoInit, DoStart, DoStop and DoDestroy: OBootParam for the reason oreasonBOOT,
// OShutdownParam for the reason oreasonSHUTDOWN.  Which parameter belongs to which reason is
// inferred from the names.
struct OBootParam {
  OMemoryStickStatus memoryStickStatus;

  OBootParam() : memoryStickStatus(omemorystickUNDEF) {}
  OBootParam(OMemoryStickStatus status) : memoryStickStatus(status) {}
};
struct OShutdownParam {
  bool batteryEnough;

  OShutdownParam() : batteryEnough(false) {}
  OShutdownParam(bool enough) : batteryEnough(enough) {}
};

// The reasons for OPENR::Fatal(), which switches the robot off at once.  The robot plays a tune for
// each reason except ofatalPAUSE_SW.
typedef longword OFatal;
const OFatal ofatalUNDEF = 0xffffffff;
const OFatal ofatalMEMORY_STICK = 0;
const OFatal ofatalPAUSE_SW = 1;
const OFatal ofatalORB = 2;

// ---- limits of texts, in characters without the closing NUL

const size_t oserviceNAME_MAX = 127;  // name of a service: "Object.Name.DataType.S"
const size_t oobjectNAME_MAX = 63;    // name of an object in its .ocf file
const size_t ovrNAME_MAX = 31;
const size_t ovrPATH_MAX = 127;
const size_t orobotdesignNAME_MAX = 31;     // name of a robot design: "ERS-210"
const size_t odesignkeywordNAME_MAX = 127;  // keyword in DESIGNDB.CFG

// ---- frame numbers: one counter of frames of 8 ms for commands, sensors, images and sound

const longword oframeMAX_NUMBER = 0x0ffffff0;  // largest frame number; on the host, 0 comes next
const longword oframeINVALID_NUMBER = 0xffffffff;

// ---- devices

typedef longword ODeviceID;
typedef longword ODeviceType;
const ODeviceType odevtypeUNDEF = 0;
const ODeviceType odevtypeHUB = 1;
const ODeviceType odevtypeSERVO = 2;
const ODeviceType odevtypeAUDIO = 3;
const ODeviceType odevtypeFBK = 4;

typedef longword OPrimitiveID;
const OPrimitiveID oprimitiveID_UNDEF = 0xffffffff;

typedef longword OCPCModelID;
const OCPCModelID ocpcmodelID_UNDEF = 0xffffffff;

typedef longword OAsyncReqID;
const OAsyncReqID oasyncReqID_UNDEF = 0xffffffff;
const size_t oasyncReqID_MAX_SIZE = 32;

// A key that lets several vectors start together; see OPENR::NewSyncKey().
typedef longword OVRSyncKey;
const OVRSyncKey ovrsynckeyUNDEF = 0xffffffff;
const size_t ovrsynckeyMAX_NUM_KEY = 8;  // largest number of keys that exist at one time
const size_t ovrsynckeyMAX_SIZE = 8;
const size_t ovrsynckeyMAX_NUM_DIVISION = 16;  // largest number of parts of a divided key

typedef longword OVRRequest;
const OVRRequest ovrreqUNDEF = 0xffffffff;
const size_t ovrctrlPARAM_MAX_SIZE = 192;  // in bytes
const size_t ovrctrlDEVICE_MAX = 32;

// A request of OPENR::ControlPrimitive(); the values are in OPrimitiveControl.h.
typedef longword OPrimitiveRequest;
const OPrimitiveRequest oprmreqUNDEF = 0xffffffff;
const size_t oprmctrlPARAM_MAX_SIZE = 176;  // in bytes

// A position of the volume switch, from silent (0) to loud (3).
typedef byte OVolumeSwitch;
const OVolumeSwitch ovolumeSW0 = 0;
const OVolumeSwitch ovolumeSW1 = 1;
const OVolumeSwitch ovolumeSW2 = 2;
const OVolumeSwitch ovolumeSW3 = 3;

// ---- files that OPENR::FindDesignData() finds by keyword

typedef longword ODesignDataID;
const ODesignDataID odesigndataID_UNDEF = 0xffffffff;

// A keyword for OPENR::FindDesignData() that needs no line in DESIGNDB.CFG, because the system
// itself makes the data, an OCPUInfo.
#define odesignkeywordCPUINFO "SYS_CPUINFO"

struct OCPUInfo {
  longword sclk;  // clock of the system in Hz
  longword pclk;  // clock of the processor in Hz
  longword processorID;
  byte reserved[244];
};

#endif  // OPENR_OPENR_H_INCLUDED
