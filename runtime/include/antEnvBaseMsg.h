// The base class of all messages to the network stack.
//
// A message is request and answer in one: the stack fills in the output fields and returns the
// message, either from Call() or, after Send(), to an entry of the sender.
#ifndef OPENR_ANTENVBASEMSG_H_INCLUDED
#define OPENR_ANTENVBASEMSG_H_INCLUDED

#include <antModuleRef.h>
#include <antStackRef.h>
#include <antTypes.h>

// The argument type of an entry that receives answers: void ReceiveCont(ANTENVMSG msg).
#define ANTENVMSG void*

// The selectors of the entries of the network stack.
const Selector Entry_antEnv_Initialize = 0;
const Selector Entry_antEnv_HartBeat = 1;
const Selector Entry_antEnv_External = 2;
enum { antEnv_numEntries = 3 };

enum antEnvInvocationType { ANTENVMSG_SEND = 0, ANTENVMSG_CALL = 1 };

// The entry of an object to which the network stack sends the answer to a message.
struct antEnvMsgContInfo {
  OID oid;
  Selector selector;

  antEnvMsgContInfo() : selector(UNDEF) {}

  OID GetOID() const { return oid; }
  Selector GetSelector() const { return selector; }
};

// The base class of all messages to the network stack; 40 bytes on the robot, more with 64-bit
// pointers.  It has no virtual functions.
class antEnvMsg {
 public:
  Selector dstSelector;    // a constant Entry_antEnv_...
  antModuleRef dstModule;  // the endpoint to which the message goes; null: the stack itself
  int32 dstOperation;
  OID sender;
  int32 msgSize;  // the size that the sender gave to Send() or Call(), which may be wrong
  antEnvInvocationType invocationType;
  antEnvMsgContInfo contInfo;
  void* continuation;  // any value of the sender; the answer has the same value

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

  // Posts a copy of the message and returns; the answer is sent to entry `selector` of object
  // `oid`. ANT_SUCCESS means only that the message was posted; the operation may still fail.
  antError Send(antStackRef target, OID& oid, int32 selector, int size);

  // Sends this message to the network stack, waits for the answer and puts it into this message.
  // Only the calling object waits.
  antError Call(antStackRef target, int size);

  // Returns the answer of the network stack that the running entry of the program has received.
  // The program calls this as the first statement of the entry, and casts the answer to its real
  // type.  The answer is valid until the entry returns.
  static antEnvMsg* Receive(ANTENVMSG msg);

  int32 GetOperation() const { return dstOperation; }
  OID& GetSender() { return sender; }

  // Sends the message, which now contains the answer, back to the sender; called by an object that
  // acts as a network stack.
  antError Reply();
};

// A message with an error field.  The numbers of errors depend on the protocol, but 1 means
// "failed" in every protocol.  The fields of the operation follow in derived classes.
template <class Error>
class antOperationMsg : public antEnvMsg {
 public:
  Error error;  // set by the network stack in its answer

  explicit antOperationMsg(int32 operation) : antEnvMsg(operation), error(static_cast<Error>(1)) {}
  antOperationMsg(const antModuleRef& module, int32 operation)
      : antEnvMsg(operation), error(static_cast<Error>(1)) {
    dstModule = module;
  }

  // Sets the error and sends the message back to the sender; called by an object that acts as a
  // network stack.
  antError Reply(Error e) {
    error = e;
    return antEnvMsg::Reply();
  }
};

#endif  // OPENR_ANTENVBASEMSG_H_INCLUDED
