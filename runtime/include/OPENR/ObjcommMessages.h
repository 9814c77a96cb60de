// The messages that subjects, observers and the service manager exchange.
//
// Sizes are the robot's on a 32-bit target; pointers make them larger on a
// 64-bit host, where they never leave the process.
#ifndef OPENR_OBJCOMMMESSAGES_H_INCLUDED
#define OPENR_OBJCOMMMESSAGES_H_INCLUDED

#include <MemoryRegion.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommTypes.h>

class RCRegion;

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

// Service manager to observer: connect to the subject whose Control entry is `entry`.
struct OConnectMessage {
  OMessageType msgType;
  OConnectCmd command;
  OServiceEntry entry;
  char subName[oserviceNAME_MAX + 1];
};

// Observer to subject, with the buffer the subject shall keep for it.
struct OControlMessage {
  OMessageType msgType;
  ObjcommCommand command;
  ObserverID observerID;
  longword d_skip;
  longword d_min;
  longword d_max;
  char subName[oserviceNAME_MAX + 1];
};

struct OControlReplyMessage {
  OMessageType msgType;
  OStatus status;
  SubjectID subjectID;
  MemoryRegionID memID;
};

// Observer to subject: ready or not, and the regions it gives back.
struct OReadyMessage {
  OMessageType msgType;
  ObjcommCommand command;
  ObserverID observerID;
  int numOfData;
  RCRegion* rcRegion[MAX_NUM_DATA];  // of the subject
};

// Subject to observer.
struct ONotifyMessage {
  OMessageType msgType;
  SubjectID subjectID;
  short numOfData;
  short numOfNotify;
  struct {
    RCRegion* srcRCR;  // of the subject
    MemoryRegionID memID;
    unsigned int offset;
    size_t size;
  } data[MAX_NUM_DATA];
};

#endif  // OPENR_OBJCOMMMESSAGES_H_INCLUDED
