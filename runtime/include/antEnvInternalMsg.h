// Messages to the network stack itself, about endpoints, shared buffers and parameters.
#ifndef OPENR_ANTENVINTERNALMSG_H_INCLUDED
#define OPENR_ANTENVINTERNALMSG_H_INCLUDED

#include <antEnvBaseMsg.h>
#include <antSharedBuffer.h>

// The operations that a message to the network stack's entry Entry_antEnv_External can request
// (field dstOperation).
const int32 antEnv_Operation_CreateEndpoint = -1;
const int32 antEnv_Operation_CreateSharedBuffer = -2;
const int32 antEnv_Operation_DestroySharedBuffer = -3;

// The operations that a message to the network stack's entry Entry_antEnv_Initialize can request
// (field dstOperation).
const int32 antEnv_Operation_InitSetParam = -1;
const int32 antEnv_Operation_InitStart = -2;
const int32 antEnv_Operation_InitGetParam = -3;

const int32 antEnv_InitParam_Int32 = -1;
const int32 antEnv_InitParam_String = -2;

// Sizes in bytes of the name and of the text value of a parameter of the network stack, with the
// closing NUL.
#define ANTENV_KEY_LENGTH_MAX 32
#define ANTENV_VALUE_LENGTH_MAX 32

// Asks the network stack to make an endpoint, for instance for one TCP connection.
struct antEnvCreateEndpointMsg : public antOperationMsg<antError> {
  int32 protocol;  // a constant EndpointType_...
  int32 poolSize;  // size in bytes of the memory for packets; must be more than the largest send
  antModuleRef moduleRef;  // in the answer: the new endpoint

  antEnvCreateEndpointMsg(int32 type = 0, int32 pool = 0)
      : antOperationMsg<antError>(antEnv_Operation_CreateEndpoint),
        protocol(type),
        poolSize(pool) {}
};

struct antEnvCreateSharedBufferMsg : public antOperationMsg<antError> {
  uint32 size;             // in bytes
  antSharedBuffer buffer;  // set by the network stack in its answer

  antEnvCreateSharedBufferMsg(uint32 bytes = 0)
      : antOperationMsg<antError>(antEnv_Operation_CreateSharedBuffer), size(bytes) {}
};

// Destroys a shared buffer, which must be unmapped before.
struct antEnvDestroySharedBufferMsg : public antOperationMsg<antError> {
  antSharedBuffer buffer;

  antEnvDestroySharedBufferMsg()
      : antOperationMsg<antError>(antEnv_Operation_DestroySharedBuffer) {}
  antEnvDestroySharedBufferMsg(antSharedBuffer& buf)
      : antOperationMsg<antError>(antEnv_Operation_DestroySharedBuffer), buffer(buf) {}
};

union antEnvParamValue {
  char str[ANTENV_VALUE_LENGTH_MAX];
  int32 i32;
};

// Asks for a parameter of the network stack by name; "ETHER_IP" gives the robot's address as text.
struct antEnvInitGetParamMsg : public antEnvMsg {
  int32 paramType;  // in the answer: a constant antEnv_InitParam_...
  char key[ANTENV_KEY_LENGTH_MAX];
  antEnvParamValue value;  // set by the network stack in its answer
  antError error;          // set by the network stack in its answer

  antEnvInitGetParamMsg();
  antEnvInitGetParamMsg(const char* name);
  antError Reply(antError e) {
    error = e;
    return antEnvMsg::Reply();
  }
};

// Sets a parameter of the network stack; allowed to system objects only.
struct antEnvInitSetParamMsg : public antEnvMsg {
  int32 paramType;  // a constant antEnv_InitParam_...
  char key[ANTENV_KEY_LENGTH_MAX];
  antEnvParamValue value;
  antError error;  // set by the network stack in its answer

  antEnvInitSetParamMsg();
  antEnvInitSetParamMsg(const char* name, int32 number);
  antEnvInitSetParamMsg(const char* name, const char* text);
  antError Reply(antError e) {
    error = e;
    return antEnvMsg::Reply();
  }
};

// Starts the network stack; allowed to system objects only.
struct antEnvInitStartMsg : public antEnvMsg {
  antError error;  // set by the network stack in its answer

  antEnvInitStartMsg();
  antError Reply(antError e) {
    error = e;
    return antEnvMsg::Reply();
  }
};

#endif  // OPENR_ANTENVINTERNALMSG_H_INCLUDED
