// What the runtime has to know about every message to the network stack: how many
// bytes it has, how it is called, what of it goes into a hash.
//
// The protocol is told from the endpoint's reference, which carries its number where
// the robot has a pointer (MakeModuleRef), so that no table is needed to know the type of
// a message, and no address is in it.
#pragma once

#include <antEnvMsg.h>

#include <cstddef>
#include <cstdint>

namespace openr_host {

antModuleRef MakeModuleRef(int32_t protocol, uint32_t index);

// EndpointType_...; 0 for the null reference and for ones that no stack made.
int32_t ProtocolOf(const antModuleRef& ref);

// Bytes of the struct that selector, protocol and operation of `message` stand for.  What
// Send() and Call() are told is not trusted: samples pass the size of another struct.
// Base and error field only, when there is no such operation.
size_t AntMessageSize(const antEnvMsg& message);

// "TCP Listen", for messages to people.
const char* AntMessageName(const antEnvMsg& message);

// Sets the error field, wherever it lies.
void SetAntError(antEnvMsg* message, int32_t error);

// In an answer that is an error: nothing was received, nothing was found.  Programs look
// at counts without looking at the error.
void ClearCounts(antEnvMsg* message);

// XXH3 over the fields that have a meaning, without addresses, continuation and padding, and
// over the bytes transferred, if any.  Never 0.
uint64_t AntMessageHash(const antEnvMsg& message, const void* data = nullptr, size_t size = 0);

// The bytes that a Send of TCP or UDP names; size 0 for other messages.
struct AntData {
  const byte* begin = nullptr;
  int size = 0;
};
AntData DataToSend(const antEnvMsg& message);

// Where `message` points into a shared buffer; null when it has no such pointer.  `sent` and
// `received` are bytes there that belong to the request, and to the answer.
struct AntBuffer {
  byte** pointer = nullptr;
  int sent = 0;
  int received = 0;
};
AntBuffer BufferOf(antEnvMsg* message);

}  // namespace openr_host
