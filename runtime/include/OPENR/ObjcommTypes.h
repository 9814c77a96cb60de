// Types shared by subjects, observers and their messages.
//
// Values and names are from the SDK reference, section 2.1 (docs/openr).
#ifndef OPENR_OBJCOMMTYPES_H_INCLUDED
#define OPENR_OBJCOMMTYPES_H_INCLUDED

#include <OPENR/OPENR.h>
#include <OPENR/StandardNames.h>

// The largest number of data items in one notification.
#define MAX_NUM_DATA 13

// The largest number of regions that an OReadyMessageV10 can give back.  This message is an older
// form of the ready, which the host does not send.
const int objcommMAX_NUM_UNLOCK = 29;

// An id: the object, and the selector of the Ready entry for a subject, or of the Notify entry for
// an observer.  The two kinds of ids have the same C++ type.
typedef OServiceEntry SubjectID;
typedef OServiceEntry ObserverID;

inline SubjectID ENTRY2SUBJECTID(const OServiceEntry& entry) { return entry; }
inline ObserverID ENTRY2OBSERVERID(const OServiceEntry& entry) { return entry; }

// Prints an id in the form "(OID:0x80000042 ,Sel:7)".
ostream& operator<<(ostream& out, const ObserverID& id);

typedef int ObjcommCommand;
const ObjcommCommand objcommCMD_UNDEF = 0;
const ObjcommCommand objcommCMD_ADDOBSERVER = 1;
const ObjcommCommand objcommCMD_REMOVEOBSERVER = 2;
const ObjcommCommand objcommCMD_ASSERT_READY = 3;
const ObjcommCommand objcommCMD_DEASSERT_READY = 4;
const ObjcommCommand objcommCMD_ADDOBSERVER_SELF = 5;
const ObjcommCommand objcommCMD_REMOVEOBSERVER_SELF = 6;
const ObjcommCommand objcommCMD_ADDOBSERVER_V22 = 7;
const ObjcommCommand objcommCMD_REMOVEOBSERVER_V22 = 8;

typedef longword ObjcommMessageType;
const ObjcommMessageType objcommMSG_UNDEF = 0;
const ObjcommMessageType objcommMSG_NOTIFY = 1;
const ObjcommMessageType objcommMSG_CONTROL = 2;
const ObjcommMessageType objcommMSG_READY = 3;

typedef longword ObjcommDataType;
const ObjcommDataType objcommDATA_TYPE_UNDEF = 0;
const ObjcommDataType objcommDATA_TYPE_MSG = 1;
const ObjcommDataType objcommDATA_TYPE_SHM = 2;

typedef int ObjcommStatus;
const ObjcommStatus objcommSUCCESS = 0;
const ObjcommStatus objcommNOTIFY_UNDEF = 1;
const ObjcommStatus objcommFRAMENUMBER_UNDEF = 2;
const ObjcommStatus objcommADDOBSERVER_FAIL = 3;
const ObjcommStatus objcommREMOVEOBSERVER_FAIL = 4;
const ObjcommStatus objcommCOMMAND_UNDEF = 5;

typedef unsigned int ObjcommVersion;
const ObjcommVersion objcommVERSION10 = 1;
const ObjcommVersion objcommVERSION20 = 2;
const ObjcommVersion objcommVERSION21 = 3;
const ObjcommVersion objcommVERSION22 = 4;  // the version of this library
const ObjcommVersion objcommVERSION_UNDEF = 0xffffffff;

#endif  // OPENR_OBJCOMMTYPES_H_INCLUDED
