// Properties of messages to the network stack: size, name, and the fields that are hashed.
//
// On the robot, a reference to an endpoint contains a pointer.  On the host, the reference contains
// the number of the protocol instead of the pointer (MakeModuleRef).  So the type of a message is
// known even if its endpoint is closed already.  Also, references do not differ between runs,
// because they contain no memory address.
#pragma once

#include <TCPEndpointMsg.h>
#include <antEnvMsg.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace openr_host {

antModuleRef MakeModuleRef(int32_t protocol, uint32_t index);

// Returns the protocol (EndpointType_...) of the endpoint to which `ref` refers.  Returns 0 for the
// null reference and for references that no network stack has made.
int32_t ProtocolOf(const antModuleRef& ref);

// Returns the size of the struct of `message`.  Selector, protocol and operation of the message
// determine the struct.  The size that a program gives to Send() or Call() is not used, because
// Sony's samples pass the size of a wrong struct.  For an unknown operation, returns the size of
// antEnvMsg and the error field.
size_t AntMessageSize(const antEnvMsg& message);

// Returns a name such as "TCP Listen", for messages to the user.
const char* AntMessageName(const antEnvMsg& message);

// Returns the name of `message` and the values of its fields that have a meaning, such as
// "TCP Connect, endpoint 2, from 10.0.1.100:1024 to 10.0.1.2:54000, TCP_SUCCESS".  Memory addresses
// are left out, because they differ from run to run.  The error is shown only with `is_answer`,
// because a request has none.
std::string AntMessageText(const antEnvMsg& message, bool is_answer);

// Sets the error field of `message`; its position depends on the type of `message`.
void SetAntError(antEnvMsg* message, int32_t error);

// Sets the numbers of received bytes or found addresses in an answer with an error to 0, because
// programs use these numbers without checking the error.
void ClearCounts(antEnvMsg* message);

// Returns the XXH3 hash of `message` for the trace of a run: the hash of the transferred bytes at
// `data` and of the fields that have a meaning.  Memory addresses, the field `continuation` (a
// value of the sender) and padding are left out, because they differ from run to run.  Never
// returns 0, which means "no hash" in a Message.
uint64_t AntMessageHash(const antEnvMsg& message, const void* data = nullptr, size_t size = 0);

// Returns whether the field `abort` of `message` is not 0.  Reads the field as a byte, not as a
// bool: if a program has written another message into the same memory, the byte may be neither 0
// nor 1, which C++ does not allow for a bool.
bool IsAbort(const TCPEndpointCloseMsg& message);

// The bytes that a Send message of TCP or UDP sends; the size is 0 for other messages.
struct AntData {
  const byte* begin = nullptr;
  int size = 0;
};
AntData DataToSend(const antEnvMsg& message);

// Describes the field of a message that points into a shared buffer.  `pointer` is the address of
// this field, or null if the message has no such field.  A request sends the `sent` bytes to which
// the field points; its answer may write up to `received` bytes there.
struct AntBuffer {
  byte** pointer = nullptr;
  int sent = 0;
  int received = 0;
};
AntBuffer BufferOf(antEnvMsg* message);

}  // namespace openr_host
