// Messages of the network stack and of the wireless card: net 2 to 9.
#include <DNSEndpointMsg.h>
#include <ERA201D1.h>
#include <IPAddress.h>
#include <IPEndpointMsg.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>

#include "abi.h"

void CheckEnvironment() {
  SIZE(IPAddress, 4);
  SIZE(Port, 2);
  SIZE(Protocol, 2);
  SIZE(boolean, 4);

  SIZE(antModuleRef, 8);
  AT(antModuleRef, module, 0);
  AT(antModuleRef, index, 4);
  SIZE(antSharedBuffer, 16);

  SIZE(antEnvMsg, 40);
  AT(antEnvMsg, dstSelector, 0);
  AT(antEnvMsg, dstModule, 4);
  AT(antEnvMsg, dstOperation, 12);
  AT(antEnvMsg, sender, 16);
  AT(antEnvMsg, msgSize, 20);
  AT(antEnvMsg, invocationType, 24);
  AT(antEnvMsg, contInfo, 28);
  AT(antEnvMsg, continuation, 36);

  SIZE(antEnvCreateEndpointMsg, 60);
  AT(antEnvCreateEndpointMsg, error, 40);
  AT(antEnvCreateEndpointMsg, protocol, 44);
  AT(antEnvCreateEndpointMsg, poolSize, 48);
  AT(antEnvCreateEndpointMsg, moduleRef, 52);

  SIZE(antEnvCreateSharedBufferMsg, 64);
  AT(antEnvCreateSharedBufferMsg, error, 40);
  AT(antEnvCreateSharedBufferMsg, size, 44);
  AT(antEnvCreateSharedBufferMsg, buffer, 48);
  SIZE(antEnvDestroySharedBufferMsg, 60);
  AT(antEnvDestroySharedBufferMsg, error, 40);
  AT(antEnvDestroySharedBufferMsg, buffer, 44);

  SIZE(antEnvInitGetParamMsg, 112);
  AT(antEnvInitGetParamMsg, paramType, 40);
  AT(antEnvInitGetParamMsg, key, 44);
  AT(antEnvInitGetParamMsg, value, 76);
  AT(antEnvInitGetParamMsg, error, 108);
  SIZE(antEnvInitSetParamMsg, 112);
}

// Listen, Connect, BacklogListen and Accept name both ends.
#define CHECK_ENDS(type)  \
  SIZE(type, 60);         \
  AT(type, lAddress, 44); \
  AT(type, lPort, 48);    \
  AT(type, fAddress, 52); \
  AT(type, fPort, 56)

void CheckTcp() {
  AT(TCPEndpointListenMsg, error, 40);
  CHECK_ENDS(TCPEndpointListenMsg);
  CHECK_ENDS(TCPEndpointConnectMsg);
  CHECK_ENDS(TCPEndpointBacklogListenMsg);
  CHECK_ENDS(TCPEndpointAcceptMsg);
  AT(TCPEndpointAcceptMsg, queueNr, 58);

  SIZE(TCPEndpointSendMsg, 56);
  AT(TCPEndpointSendMsg, buffer, 44);
  AT(TCPEndpointSendMsg, size, 48);
  AT(TCPEndpointSendMsg, queueNr, 52);
  SIZE(TCPEndpointReceiveMsg, 60);
  AT(TCPEndpointReceiveMsg, buffer, 44);
  AT(TCPEndpointReceiveMsg, sizeMin, 48);
  AT(TCPEndpointReceiveMsg, sizeMax, 52);
  AT(TCPEndpointReceiveMsg, queueNr, 56);
  SIZE(TCPEndpointCloseMsg, 56);
  AT(TCPEndpointCloseMsg, abort, 44);
  AT(TCPEndpointCloseMsg, linger, 45);
  AT(TCPEndpointCloseMsg, lingerTime, 48);
  AT(TCPEndpointCloseMsg, queueNr, 52);
  SIZE(TCPEndpointBindMsg, 52);
  AT(TCPEndpointBindMsg, lAddress, 44);
  AT(TCPEndpointBindMsg, lPort, 48);
  SIZE(TCPEndpointSetBlockingModeMsg, 48);
  AT(TCPEndpointSetBlockingModeMsg, blocking, 44);
  AT(TCPEndpointSetBlockingModeMsg, queueNr, 46);
  SIZE(TCPEndpointReadyForReadMsg, 52);
  AT(TCPEndpointReadyForReadMsg, ready, 44);
  AT(TCPEndpointReadyForReadMsg, queueNr, 48);
  SIZE(TCPEndpointReadyForWriteMsg, 52);
  SIZE(TCPEndpointBacklogQueueMsg, 48);
  AT(TCPEndpointBacklogQueueMsg, backlog, 44);
  SIZE(TCPEndpointAddressMsg, 64);
  AT(TCPEndpointAddressMsg, queueNr, 44);
  AT(TCPEndpointAddressMsg, lAddress, 48);
  AT(TCPEndpointAddressMsg, lPort, 52);
  AT(TCPEndpointAddressMsg, fAddress, 56);
  AT(TCPEndpointAddressMsg, fPort, 60);
}

void CheckUdp() {
  SIZE(UDPEndpointBindMsg, 52);
  AT(UDPEndpointBindMsg, address, 44);
  AT(UDPEndpointBindMsg, port, 48);
  SIZE(UDPEndpointConnectMsg, 52);
  AT(UDPEndpointConnectMsg, address, 44);
  AT(UDPEndpointConnectMsg, port, 48);
  SIZE(UDPEndpointSendMsg, 60);
  AT(UDPEndpointSendMsg, address, 44);
  AT(UDPEndpointSendMsg, port, 48);
  AT(UDPEndpointSendMsg, buffer, 52);
  AT(UDPEndpointSendMsg, size, 56);
  SIZE(UDPEndpointReceiveMsg, 60);
  AT(UDPEndpointReceiveMsg, address, 44);
  AT(UDPEndpointReceiveMsg, port, 48);
  AT(UDPEndpointReceiveMsg, buffer, 52);
  AT(UDPEndpointReceiveMsg, size, 56);
  SIZE(UDPEndpointCloseMsg, 52);
  AT(UDPEndpointCloseMsg, linger, 44);
  AT(UDPEndpointCloseMsg, lingerTime, 48);
  SIZE(UDPEndpointSetBlockingModeMsg, 48);
  AT(UDPEndpointSetBlockingModeMsg, blocking, 44);
  SIZE(UDPEndpointReadyForReadMsg, 48);
  AT(UDPEndpointReadyForReadMsg, ready, 44);
  SIZE(UDPEndpointReadyForWriteMsg, 48);
  SIZE(UDPEndpointAddressMsg, 60);
  AT(UDPEndpointAddressMsg, lAddress, 44);
  AT(UDPEndpointAddressMsg, lPort, 48);
  AT(UDPEndpointAddressMsg, fAddress, 52);
  AT(UDPEndpointAddressMsg, fPort, 56);
  SIZE(UDPEndpointResetConnectMsg, 44);
}

#define CHECK_HOST(type)         \
  SIZE(type, 160);               \
  AT(type, name, 44);            \
  AT(type, server_address, 144); \
  AT(type, host_address, 148);   \
  AT(type, n_address, 152);      \
  AT(type, n_alias, 156)

void CheckDns() {
  SIZE(DNSEndpointSetServerAddressesMsg, 60);
  AT(DNSEndpointSetServerAddressesMsg, nscount, 44);
  AT(DNSEndpointSetServerAddressesMsg, addrList, 48);
  SIZE(DNSEndpointGetServerAddressesMsg, 60);
  SIZE(DNSEndpointSetDefaultDomainNameMsg, 144);
  AT(DNSEndpointSetDefaultDomainNameMsg, name, 44);
  SIZE(DNSEndpointGetDefaultDomainNameMsg, 144);
  CHECK_HOST(DNSEndpointGetHostByNameMsg);
  CHECK_HOST(DNSEndpointGetHostByAddrMsg);
  SIZE(DNSEndpointGetAddressMsg, 52);
  AT(DNSEndpointGetAddressMsg, index, 44);
  AT(DNSEndpointGetAddressMsg, address, 48);
  SIZE(DNSEndpointGetAliasMsg, 148);
  AT(DNSEndpointGetAliasMsg, index, 44);
  AT(DNSEndpointGetAliasMsg, name, 48);
  SIZE(DNSEndpointCloseMsg, 44);

  SIZE(IPEndpointBindMsg, 48);
  AT(IPEndpointBindMsg, protocol, 44);
  SIZE(IPEndpointSendMsg, 56);
  AT(IPEndpointSendMsg, type, 44);
  AT(IPEndpointSendMsg, buffer, 48);
  AT(IPEndpointSendMsg, size, 52);
  SIZE(IPEndpointReceiveMsg, 56);
  AT(IPEndpointReceiveMsg, type, 44);
  AT(IPEndpointReceiveMsg, buffer, 48);
  AT(IPEndpointReceiveMsg, size, 52);
}

void CheckEther() {
  SIZE(EtherMACAddress, 6);
  SIZE(EtherDriverGetMACAddressMsg, 16);
  AT(EtherDriverGetMACAddressMsg, address, 4);
  AT(EtherDriverGetMACAddressMsg, status, 12);
  SIZE(EtherDriverGetStatisticsMsg, 44);
  AT(EtherDriverGetStatisticsMsg, statistics, 4);
  AT(EtherDriverGetStatisticsMsg, status, 40);
  SIZE(EtherDriverGetWLANSettingsMsg, 104);
  AT(EtherDriverGetWLANSettingsMsg, mode, 4);
  AT(EtherDriverGetWLANSettingsMsg, essid, 8);
  AT(EtherDriverGetWLANSettingsMsg, stationName, 41);
  AT(EtherDriverGetWLANSettingsMsg, channel, 76);
  AT(EtherDriverGetWLANSettingsMsg, status, 100);
  SIZE(EtherDriverGetWLANStatisticsMsg, 24);
}
