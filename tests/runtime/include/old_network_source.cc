// A source like old_source.cc, of a program that uses the network.
#include <DNSEndpointMsg.h>
#include <ERA201D1.h>
#include <EndpointTypes.h>
#include <OPENR/OObject.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>

using namespace std;

class OldServer : public OObject {
 public:
  OStatus Listen(long index);
  void ReceiveCont(ANTENVMSG msg);

 private:
  antStackRef ipstackRef;
  antModuleRef endpoint;
  antSharedBuffer recvBuffer;
  byte* recvData;
};

OStatus OldServer::Listen(long index) {
  ipstackRef = antStackRef("IPStack");

  antEnvCreateSharedBufferMsg bufferMsg(512);
  bufferMsg.Call(ipstackRef, sizeof(bufferMsg));
  if (bufferMsg.error != ANT_SUCCESS) {
    OSYSLOG1((osyslogERROR, "buffer: %s", antErrorString(bufferMsg.error)));
    return oFAIL;
  }
  recvBuffer = bufferMsg.buffer;
  recvBuffer.Map();
  recvData = (byte*)(recvBuffer.GetAddress());

  antEnvCreateEndpointMsg tcpCreateMsg(EndpointType_TCP, 1024);
  tcpCreateMsg.Call(ipstackRef, sizeof(tcpCreateMsg));
  endpoint = tcpCreateMsg.moduleRef;

  TCPEndpointListenMsg listenMsg(endpoint, IP_ADDR_ANY, 54321, IP_ADDR_ANY, IP_PORT_ANY);
  listenMsg.continuation = (void*)index;
  antError error = listenMsg.Send(ipstackRef, myOID_, 12, sizeof(listenMsg));

  UDPEndpointBindMsg bindMsg(endpoint, IP_ADDR_ANY, 123);
  bindMsg.Call(ipstackRef, sizeof(antEnvCreateEndpointMsg));
  DNSEndpointGetHostByNameMsg dnsMsg(endpoint, "example.net.");
  dnsMsg.Send(ipstackRef, myOID_, 13, sizeof(dnsMsg));
  EtherDriverGetMACAddressMsg mac;
  EtherStatus status = ERA201D1_GetMACAddress(&mac);
  OSYSPRINT(("%s\n", etherStatusStr(status)));
  return error == ANT_SUCCESS ? oSUCCESS : oFAIL;
}

void OldServer::ReceiveCont(ANTENVMSG msg) {
  TCPEndpointReceiveMsg* receiveMsg = (TCPEndpointReceiveMsg*)antEnvMsg::Receive(msg);
  long index = (long)receiveMsg->continuation;
  if (receiveMsg->error != TCP_SUCCESS) {
    TCPEndpointCloseMsg closeMsg(endpoint);
    closeMsg.continuation = (void*)index;
    closeMsg.Send(ipstackRef, myOID_, 14, sizeof(closeMsg));
    return;
  }
  char address[16];
  OSYSPRINT(("%d bytes, %s\n", receiveMsg->sizeMin, IPAddress("10.0.1.2").GetAsString(address)));
  TCPEndpointReceiveMsg again(endpoint, recvData, 1, 512);
  again.Send(ipstackRef, myOID_, 12, sizeof(again));
}
