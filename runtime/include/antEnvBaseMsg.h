// The base of all messages to the network stack.
//
// A message is question and answer in one: the stack fills in the output fields and gives
// it back, either from Call() or, after Send(), to an entry of the sender.
#ifndef OPENR_ANTENVBASEMSG_H_INCLUDED
#define OPENR_ANTENVBASEMSG_H_INCLUDED

#include <antModuleRef.h>
#include <antStackRef.h>
#include <antTypes.h>

// Type of the argument of an entry that takes answers: void ReceiveCont(ANTENVMSG msg).
#define ANTENVMSG void*

// Entries of the stack object.
const Selector Entry_antEnv_Initialize = 0;
const Selector Entry_antEnv_HartBeat = 1;
const Selector Entry_antEnv_External = 2;
enum { antEnv_numEntries = 3 };

enum antEnvInvocationType { ANTENVMSG_SEND = 0, ANTENVMSG_CALL = 1 };

// Where an answer goes.
struct antEnvMsgContInfo {
  OID oid;
  Selector selector;

  antEnvMsgContInfo() : selector(UNDEF) {}

  OID GetOID() const { return oid; }
  Selector GetSelector() const { return selector; }
};

// 40 bytes on the robot, more with 64-bit pointers; no virtual functions.
class antEnvMsg {
 public:
  Selector dstSelector;    // Entry_antEnv_...
  antModuleRef dstModule;  // the endpoint; null: the stack itself
  int32 dstOperation;
  OID sender;
  int32 msgSize;  // as given to Send or Call, so not to be trusted
  antEnvInvocationType invocationType;
  antEnvMsgContInfo contInfo;
  void* continuation;  // the sender's own; comes back as it was

  antEnvMsg()
      : dstSelector(Entry_antEnv_External),
        dstOperation(0),
        msgSize(0),
        invocationType(ANTENVMSG_SEND),
        continuation(0) {}
  explicit antEnvMsg(int32 operation, Selector selector = Entry_antEnv_External)
      : dstSelector(selector),
        dstOperation(operation),
        msgSize(0),
        invocationType(ANTENVMSG_SEND),
        continuation(0) {}

  // Posts a copy of the message and returns; the answer comes to entry `selector` of
  // object `oid`.  ANT_SUCCESS says that it was posted, not that it will succeed.
  antError Send(antStackRef target, OID& oid, int32 selector, int size);

  // Waits for the answer and puts it into this message.  Blocks the calling object.
  antError Call(antStackRef target, int size);

  // First statement of an entry that takes answers: the message, valid during the entry,
  // to be cast to its real type.
  static antEnvMsg* Receive(ANTENVMSG msg);

  int32 GetOperation() const { return dstOperation; }
  OID& GetSender() { return sender; }

  // For the stack: gives the message back with its answer.
  antError Reply();
};

// A message with a result of its own, in the numbers of its protocol; 1 is "failed" in all
// of them.  The fields of the operation follow.
template <class Error>
class antOperationMsg : public antEnvMsg {
 public:
  Error error;  // out; meaningful in the answer only

  explicit antOperationMsg(int32 operation) : antEnvMsg(operation), error(static_cast<Error>(1)) {}
  antOperationMsg(const antModuleRef& module, int32 operation)
      : antEnvMsg(operation), error(static_cast<Error>(1)) {
    dstModule = module;
  }

  // For the stack: sets the result and gives the message back.
  antError Reply(Error e) {
    error = e;
    return antEnvMsg::Reply();
  }
};

#endif  // OPENR_ANTENVBASEMSG_H_INCLUDED
