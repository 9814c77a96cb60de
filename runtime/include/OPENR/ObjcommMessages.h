// The messages that subjects, observers and the object manager exchange.
//
// On a 32-bit target the sizes are those of the robot.  On a 64-bit host pointers make the messages
// larger.  The larger size does no harm, because no message leaves the process in this form.
#ifndef OPENR_OBJCOMMMESSAGES_H_INCLUDED
#define OPENR_OBJCOMMMESSAGES_H_INCLUDED

#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommTypes.h>
#include <OPENR/RCRegion.h>
#include <string.h>

const OMessageType omsgCONTROL = 12;
const OMessageType omsgCONTROL_REPLY = 13;
const OMessageType omsgREADY = 14;
const OMessageType omsgNOTIFY = 15;
const OMessageType omsgCONTROL_V21 = 256;
const OMessageType omsgCONTROL_REPLY_V21 = 257;
const OMessageType omsgREADY_V21 = 258;
const OMessageType omsgNOTIFY_V21 = 259;
const OMessageType omsgNOTIFY_L10 = 260;
const OMessageType omsgREADY_V22 = 261;
const OMessageType omsgNOTIFY_V22 = 262;

// The message by which an observer asks a subject to connect or to disconnect.  d_skip, d_min and
// d_max say how the subject buffers notifications for the observer (OObserver::SetSkip()).
struct OControlMessage {
  OMessageType msgType;
  ObjcommCommand command;
  ObserverID observerID;
  longword d_skip;
  longword d_min;
  longword d_max;
  char subName[oserviceNAME_MAX + 1];

  OControlMessage() { Set(objcommCMD_UNDEF, 0, 0, 0, ""); }

  // Cuts `name`, the name of the service, if it is longer than oserviceNAME_MAX.
  OControlMessage(ObjcommCommand what, ObserverID id, size_t skip, size_t least, size_t most,
                  const char* name)
      : observerID(id) {
    Set(what, skip, least, most, name);
  }

 private:
  void Set(ObjcommCommand what, size_t skip, size_t least, size_t most, const char* name) {
    msgType = omsgCONTROL_V21;
    command = what;
    d_skip = static_cast<longword>(skip);
    d_min = static_cast<longword>(least);
    d_max = static_cast<longword>(most);
    size_t length = 0;
    while (length < oserviceNAME_MAX && name[length] != 0) length++;
    memset(subName, 0, sizeof subName);
    memcpy(subName, name, length);
  }
};

struct OControlReplyMessage {
  OMessageType msgType;
  OStatus status;
  SubjectID subjectID;
  MemoryRegionID memID;

  OControlReplyMessage() : msgType(omsgCONTROL_REPLY_V21), status(oSUCCESS), memID(0) {}
  OControlReplyMessage(OStatus result, SubjectID id, MemoryRegionID region)
      : msgType(omsgCONTROL_REPLY_V21), status(result), subjectID(id), memID(region) {}
};

// A ready, the message that an observer sends to a subject: assert or deassert, and the regions
// that are given back.
struct OReadyMessage {
  OMessageType msgType;
  ObjcommCommand command;
  ObserverID observerID;
  int numOfData;
  RCRegion* rcRegion[MAX_NUM_DATA];  // the subject's own RCRegions that are given back

  OReadyMessage() : msgType(omsgREADY_V22), command(objcommCMD_UNDEF), numOfData(0) {}
};

// A data item of a notification: a region that a subject sends to an observer.
struct TransferedData {
  RCRegion* srcRCR;  // the subject's own RCRegion, not the observer's
  MemoryRegionID memID;
  unsigned int offset;  // in bytes
  size_t size;          // in bytes
};

// A notification, the message with data that a subject sends to an observer.
struct ONotifyMessage {
  OMessageType msgType;
  SubjectID subjectID;
  short numOfData;
  short numOfNotify;
  TransferedData data[MAX_NUM_DATA];  // only the first numOfData elements are in use

  ONotifyMessage() : msgType(omsgNOTIFY_V22), numOfData(0), numOfNotify(0) {}

  int NumberOfData() const { return numOfData; }
  int NumberOfNotify() const { return numOfNotify; }

  // Returns how many bytes of this notification are in use, which depends on the number of its
  // data.
  size_t GetSizeOfMessage() const {
    return sizeof *this - (MAX_NUM_DATA - numOfData) * sizeof(TransferedData);
  }

  // Removes the data from this notification.  Does not release the references to the regions of the
  // data; the caller must do that.
  void Clear() {
    numOfData = 0;
    numOfNotify = 0;
  }

  // Appends a region to the data of this notification without taking a reference.  Returns
  // oOVERFLOW, without a change, if the notification has MAX_NUM_DATA regions already.
  OStatus Write(RCRegion* region) {
    if (numOfData == MAX_NUM_DATA) return oOVERFLOW;
    TransferedData& place = data[numOfData++];
    place.srcRCR = region;
    place.memID = region->MemID();
    place.offset = region->Offset();
    place.size = region->Size();
    return oSUCCESS;
  }
};

// ---- older messages between subjects and observers (version 1), which contain data or addresses
// instead of regions; not sent on the host

struct ONotifyMessageV10 {
  OMessageType msgType;
  SubjectID subjectID;
  int numOfData;
  unsigned int dataSize;  // number of bytes of `data` in use
  char data[236];         // the data items, each an OChunkMSG or an OChunkSHM
};

// The two forms of a data item in an ONotifyMessageV10, an older notification that the host does
// not send: OChunkMSG contains the data; OChunkSHM contains the place of the data in shared memory.
struct OChunkMSG {
  ObjcommDataType type;  // the type objcommDATA_TYPE_MSG
  unsigned int size;     // in bytes
  char data;             // the first byte of the data
};

struct OChunkSHM {
  ObjcommDataType type;  // the type objcommDATA_TYPE_SHM
  OMemoryLocator locator;
};

struct OReadyMessageV10 {
  OMessageType msgType;
  ObjcommCommand command;
  ObserverID observerID;
  int numOfUnlock;
  OMemoryLocator unlock[objcommMAX_NUM_UNLOCK];
};

#endif  // OPENR_OBJCOMMMESSAGES_H_INCLUDED
