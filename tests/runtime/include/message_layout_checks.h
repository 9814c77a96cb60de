// Sizes and offsets of the network messages on the robot, checked by the compiler.
//
// The messages hold pointers and object ids, so the figures are right for 32-bit targets
// only.  On every host a message has to fit Send(), which copies at most 256 bytes.
#ifndef TESTS_RUNTIME_INCLUDE_MESSAGE_LAYOUT_CHECKS_H
#define TESTS_RUNTIME_INCLUDE_MESSAGE_LAYOUT_CHECKS_H

#include <DNSEndpointMsg.h>
#include <IPEndpointMsg.h>
#include <RID.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>

#include "tests/runtime/include/layout_checks.h"

#define CHECK_FITS(type) static_assert(sizeof(type) <= 256, #type " fits a message")

CHECK_FITS(DNSEndpointGetHostByNameMsg);
CHECK_FITS(DNSEndpointSetDefaultDomainNameMsg);
CHECK_FITS(TCPEndpointAddressMsg);
CHECK_FITS(antEnvInitGetParamMsg);
CHECK_FITS(OReasonMessage);
CHECK_FITS(OPowerStatusMessage);

#if __SIZEOF_POINTER__ == 4

CHECK_SIZE(OID, 4);
CHECK_SIZE(OServiceEntry, 8);
CHECK_SIZE(RID, 8);
CHECK_SIZE(OSyslogMessage, 256);
#if __SIZEOF_LONG__ == 4 && !defined(__USE_TIME_BITS64)
CHECK_SIZE(OBootCondition, 16);
CHECK_OFFSET(OBootCondition, bitmap, 0);
CHECK_OFFSET(OBootCondition, bootTime, 4);
CHECK_OFFSET(OBootCondition, bootTimeType, 8);
CHECK_OFFSET(OBootCondition, vibrationLevel, 12);
#endif
CHECK_SIZE(antModuleRef, 8);
CHECK_OFFSET(antModuleRef, module, 0);
CHECK_OFFSET(antModuleRef, index, 4);
CHECK_SIZE(antSharedBuffer, 16);
CHECK_SIZE(antStackRef, 8);
CHECK_SIZE(antEnvMsg, 40);
CHECK_OFFSET(antEnvMsg, dstSelector, 0);
CHECK_OFFSET(antEnvMsg, dstModule, 4);
CHECK_OFFSET(antEnvMsg, dstOperation, 12);
CHECK_OFFSET(antEnvMsg, sender, 16);
CHECK_OFFSET(antEnvMsg, msgSize, 20);
CHECK_OFFSET(antEnvMsg, invocationType, 24);
CHECK_OFFSET(antEnvMsg, contInfo, 28);
CHECK_OFFSET(antEnvMsg, continuation, 36);
CHECK_SIZE(antEnvCreateEndpointMsg, 60);
CHECK_OFFSET(antEnvCreateEndpointMsg, error, 40);
CHECK_OFFSET(antEnvCreateEndpointMsg, protocol, 44);
CHECK_OFFSET(antEnvCreateEndpointMsg, poolSize, 48);
CHECK_OFFSET(antEnvCreateEndpointMsg, moduleRef, 52);
CHECK_SIZE(antEnvCreateSharedBufferMsg, 64);
CHECK_OFFSET(antEnvCreateSharedBufferMsg, error, 40);
CHECK_OFFSET(antEnvCreateSharedBufferMsg, size, 44);
CHECK_OFFSET(antEnvCreateSharedBufferMsg, buffer, 48);
CHECK_SIZE(antEnvDestroySharedBufferMsg, 60);
CHECK_OFFSET(antEnvDestroySharedBufferMsg, error, 40);
CHECK_OFFSET(antEnvDestroySharedBufferMsg, buffer, 44);
CHECK_SIZE(antEnvInitGetParamMsg, 112);
CHECK_OFFSET(antEnvInitGetParamMsg, paramType, 40);
CHECK_OFFSET(antEnvInitGetParamMsg, key, 44);
CHECK_OFFSET(antEnvInitGetParamMsg, value, 76);
CHECK_OFFSET(antEnvInitGetParamMsg, error, 108);
CHECK_SIZE(antEnvInitSetParamMsg, 112);
CHECK_OFFSET(antEnvInitSetParamMsg, paramType, 40);
CHECK_OFFSET(antEnvInitSetParamMsg, key, 44);
CHECK_OFFSET(antEnvInitSetParamMsg, value, 76);
CHECK_OFFSET(antEnvInitSetParamMsg, error, 108);
CHECK_SIZE(antEnvInitStartMsg, 44);
CHECK_OFFSET(antEnvInitStartMsg, error, 40);
CHECK_SIZE(TCPEndpointListenMsg, 60);
CHECK_OFFSET(TCPEndpointListenMsg, error, 40);
CHECK_OFFSET(TCPEndpointListenMsg, lAddress, 44);
CHECK_OFFSET(TCPEndpointListenMsg, lPort, 48);
CHECK_OFFSET(TCPEndpointListenMsg, fAddress, 52);
CHECK_OFFSET(TCPEndpointListenMsg, fPort, 56);
CHECK_SIZE(TCPEndpointConnectMsg, 60);
CHECK_OFFSET(TCPEndpointConnectMsg, error, 40);
CHECK_OFFSET(TCPEndpointConnectMsg, lAddress, 44);
CHECK_OFFSET(TCPEndpointConnectMsg, lPort, 48);
CHECK_OFFSET(TCPEndpointConnectMsg, fAddress, 52);
CHECK_OFFSET(TCPEndpointConnectMsg, fPort, 56);
CHECK_SIZE(TCPEndpointBacklogListenMsg, 60);
CHECK_OFFSET(TCPEndpointBacklogListenMsg, error, 40);
CHECK_OFFSET(TCPEndpointBacklogListenMsg, lAddress, 44);
CHECK_OFFSET(TCPEndpointBacklogListenMsg, lPort, 48);
CHECK_OFFSET(TCPEndpointBacklogListenMsg, fAddress, 52);
CHECK_OFFSET(TCPEndpointBacklogListenMsg, fPort, 56);
CHECK_SIZE(TCPEndpointAcceptMsg, 60);
CHECK_OFFSET(TCPEndpointAcceptMsg, queueNr, 58);
CHECK_OFFSET(TCPEndpointAcceptMsg, lAddress, 44);
CHECK_OFFSET(TCPEndpointAcceptMsg, lPort, 48);
CHECK_OFFSET(TCPEndpointAcceptMsg, fAddress, 52);
CHECK_OFFSET(TCPEndpointAcceptMsg, fPort, 56);
CHECK_SIZE(TCPEndpointSendMsg, 56);
CHECK_OFFSET(TCPEndpointSendMsg, buffer, 44);
CHECK_OFFSET(TCPEndpointSendMsg, size, 48);
CHECK_OFFSET(TCPEndpointSendMsg, queueNr, 52);
CHECK_SIZE(TCPEndpointReceiveMsg, 60);
CHECK_OFFSET(TCPEndpointReceiveMsg, buffer, 44);
CHECK_OFFSET(TCPEndpointReceiveMsg, sizeMin, 48);
CHECK_OFFSET(TCPEndpointReceiveMsg, sizeMax, 52);
CHECK_OFFSET(TCPEndpointReceiveMsg, queueNr, 56);
CHECK_SIZE(TCPEndpointCloseMsg, 56);
CHECK_OFFSET(TCPEndpointCloseMsg, abort, 44);
CHECK_OFFSET(TCPEndpointCloseMsg, linger, 45);
CHECK_OFFSET(TCPEndpointCloseMsg, lingerTime, 48);
CHECK_OFFSET(TCPEndpointCloseMsg, queueNr, 52);
CHECK_SIZE(TCPEndpointBindMsg, 52);
CHECK_OFFSET(TCPEndpointBindMsg, lAddress, 44);
CHECK_OFFSET(TCPEndpointBindMsg, lPort, 48);
CHECK_SIZE(TCPEndpointSetBlockingModeMsg, 48);
CHECK_OFFSET(TCPEndpointSetBlockingModeMsg, blocking, 44);
CHECK_OFFSET(TCPEndpointSetBlockingModeMsg, queueNr, 46);
CHECK_SIZE(TCPEndpointReadyForReadMsg, 52);
CHECK_OFFSET(TCPEndpointReadyForReadMsg, ready, 44);
CHECK_OFFSET(TCPEndpointReadyForReadMsg, queueNr, 48);
CHECK_SIZE(TCPEndpointReadyForWriteMsg, 52);
CHECK_OFFSET(TCPEndpointReadyForWriteMsg, ready, 44);
CHECK_OFFSET(TCPEndpointReadyForWriteMsg, queueNr, 48);
CHECK_SIZE(TCPEndpointBacklogQueueMsg, 48);
CHECK_OFFSET(TCPEndpointBacklogQueueMsg, backlog, 44);
CHECK_SIZE(TCPEndpointAddressMsg, 64);
CHECK_OFFSET(TCPEndpointAddressMsg, queueNr, 44);
CHECK_OFFSET(TCPEndpointAddressMsg, lAddress, 48);
CHECK_OFFSET(TCPEndpointAddressMsg, lPort, 52);
CHECK_OFFSET(TCPEndpointAddressMsg, fAddress, 56);
CHECK_OFFSET(TCPEndpointAddressMsg, fPort, 60);
CHECK_SIZE(UDPEndpointBindMsg, 52);
CHECK_OFFSET(UDPEndpointBindMsg, address, 44);
CHECK_OFFSET(UDPEndpointBindMsg, port, 48);
CHECK_SIZE(UDPEndpointConnectMsg, 52);
CHECK_OFFSET(UDPEndpointConnectMsg, address, 44);
CHECK_OFFSET(UDPEndpointConnectMsg, port, 48);
CHECK_SIZE(UDPEndpointSendMsg, 60);
CHECK_OFFSET(UDPEndpointSendMsg, address, 44);
CHECK_OFFSET(UDPEndpointSendMsg, port, 48);
CHECK_OFFSET(UDPEndpointSendMsg, buffer, 52);
CHECK_OFFSET(UDPEndpointSendMsg, size, 56);
CHECK_SIZE(UDPEndpointReceiveMsg, 60);
CHECK_OFFSET(UDPEndpointReceiveMsg, address, 44);
CHECK_OFFSET(UDPEndpointReceiveMsg, port, 48);
CHECK_OFFSET(UDPEndpointReceiveMsg, buffer, 52);
CHECK_OFFSET(UDPEndpointReceiveMsg, size, 56);
CHECK_SIZE(UDPEndpointCloseMsg, 52);
CHECK_OFFSET(UDPEndpointCloseMsg, linger, 44);
CHECK_OFFSET(UDPEndpointCloseMsg, lingerTime, 48);
CHECK_SIZE(UDPEndpointSetBlockingModeMsg, 48);
CHECK_OFFSET(UDPEndpointSetBlockingModeMsg, blocking, 44);
CHECK_SIZE(UDPEndpointReadyForReadMsg, 48);
CHECK_OFFSET(UDPEndpointReadyForReadMsg, ready, 44);
CHECK_SIZE(UDPEndpointReadyForWriteMsg, 48);
CHECK_OFFSET(UDPEndpointReadyForWriteMsg, ready, 44);
CHECK_SIZE(UDPEndpointAddressMsg, 60);
CHECK_OFFSET(UDPEndpointAddressMsg, lAddress, 44);
CHECK_OFFSET(UDPEndpointAddressMsg, lPort, 48);
CHECK_OFFSET(UDPEndpointAddressMsg, fAddress, 52);
CHECK_OFFSET(UDPEndpointAddressMsg, fPort, 56);
CHECK_SIZE(UDPEndpointResetConnectMsg, 44);
CHECK_SIZE(DNSEndpointSetServerAddressesMsg, 60);
CHECK_OFFSET(DNSEndpointSetServerAddressesMsg, nscount, 44);
CHECK_OFFSET(DNSEndpointSetServerAddressesMsg, addrList, 48);
CHECK_SIZE(DNSEndpointGetServerAddressesMsg, 60);
CHECK_OFFSET(DNSEndpointGetServerAddressesMsg, nscount, 44);
CHECK_OFFSET(DNSEndpointGetServerAddressesMsg, addrList, 48);
CHECK_SIZE(DNSEndpointSetDefaultDomainNameMsg, 144);
CHECK_OFFSET(DNSEndpointSetDefaultDomainNameMsg, name, 44);
CHECK_SIZE(DNSEndpointGetDefaultDomainNameMsg, 144);
CHECK_OFFSET(DNSEndpointGetDefaultDomainNameMsg, name, 44);
CHECK_SIZE(DNSEndpointGetHostByNameMsg, 160);
CHECK_OFFSET(DNSEndpointGetHostByNameMsg, name, 44);
CHECK_OFFSET(DNSEndpointGetHostByNameMsg, server_address, 144);
CHECK_OFFSET(DNSEndpointGetHostByNameMsg, host_address, 148);
CHECK_OFFSET(DNSEndpointGetHostByNameMsg, n_address, 152);
CHECK_OFFSET(DNSEndpointGetHostByNameMsg, n_alias, 156);
CHECK_SIZE(DNSEndpointGetHostByAddrMsg, 160);
CHECK_OFFSET(DNSEndpointGetHostByAddrMsg, name, 44);
CHECK_OFFSET(DNSEndpointGetHostByAddrMsg, server_address, 144);
CHECK_OFFSET(DNSEndpointGetHostByAddrMsg, host_address, 148);
CHECK_OFFSET(DNSEndpointGetHostByAddrMsg, n_address, 152);
CHECK_OFFSET(DNSEndpointGetHostByAddrMsg, n_alias, 156);
CHECK_SIZE(DNSEndpointGetAddressMsg, 52);
CHECK_OFFSET(DNSEndpointGetAddressMsg, index, 44);
CHECK_OFFSET(DNSEndpointGetAddressMsg, address, 48);
CHECK_SIZE(DNSEndpointGetAliasMsg, 148);
CHECK_OFFSET(DNSEndpointGetAliasMsg, index, 44);
CHECK_OFFSET(DNSEndpointGetAliasMsg, name, 48);
CHECK_SIZE(DNSEndpointCloseMsg, 44);
CHECK_SIZE(IPEndpointBindMsg, 48);
CHECK_OFFSET(IPEndpointBindMsg, protocol, 44);
CHECK_SIZE(IPEndpointSendMsg, 56);
CHECK_OFFSET(IPEndpointSendMsg, type, 44);
CHECK_OFFSET(IPEndpointSendMsg, buffer, 48);
CHECK_OFFSET(IPEndpointSendMsg, size, 52);
CHECK_SIZE(IPEndpointReceiveMsg, 56);
CHECK_OFFSET(IPEndpointReceiveMsg, type, 44);
CHECK_OFFSET(IPEndpointReceiveMsg, buffer, 48);
CHECK_OFFSET(IPEndpointReceiveMsg, size, 52);
CHECK_SIZE(IPEndpointCloseMsg, 44);

#endif  // __SIZEOF_POINTER__ == 4

#endif  // TESTS_RUNTIME_INCLUDE_MESSAGE_LAYOUT_CHECKS_H
