#include "runtime/ipstack/ant_message.h"

#include <DNSEndpointMsg.h>
#include <EndpointTypes.h>
#include <IPEndpointMsg.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <fmt/format.h>

#include <cstring>
#include <sstream>
#include <string_view>
#include <type_traits>

#include "runtime/base/hasher.h"
#include "runtime/core/message.h"

namespace openr_host {
namespace {

static_assert(sizeof(DNSEndpointGetHostByNameMsg) <= Message::kPayloadMax);

using UnknownMsg = antOperationMsg<antError>;

// Casts `m` to the message type T; M is antEnvMsg or const antEnvMsg, and the result is const like
// M.
template <typename T, typename M>
std::conditional_t<std::is_const_v<M>, const T, T>& As(M& m) {
  return static_cast<std::conditional_t<std::is_const_v<M>, const T, T>&>(m);
}

// Calls visit(m, name) for the TCP message `m`.  The operation of the message decides to which type
// `m` is cast for this call.  `name` is the name of the message for texts that users read.  The
// other Visit functions do the same for other protocols.
template <typename M, typename V>
void VisitTcp(M& m, V&& visit) {
  switch (m.dstOperation) {
    case TCPEndpoint_Operation_Bind:
      return visit(As<TCPEndpointBindMsg>(m), "TCP Bind");
    case TCPEndpoint_Operation_Listen:
      return visit(As<TCPEndpointListenMsg>(m), "TCP Listen");
    case TCPEndpoint_Operation_Connect:
      return visit(As<TCPEndpointConnectMsg>(m), "TCP Connect");
    case TCPEndpoint_Operation_Send:
      return visit(As<TCPEndpointSendMsg>(m), "TCP Send");
    case TCPEndpoint_Operation_Receive:
      return visit(As<TCPEndpointReceiveMsg>(m), "TCP Receive");
    case TCPEndpoint_Operation_Close:
      return visit(As<TCPEndpointCloseMsg>(m), "TCP Close");
    case TCPEndpoint_Operation_SetBlockingMode:
      return visit(As<TCPEndpointSetBlockingModeMsg>(m), "TCP SetBlockingMode");
    case TCPEndpoint_Operation_ReadyForRead:
      return visit(As<TCPEndpointReadyForReadMsg>(m), "TCP ReadyForRead");
    case TCPEndpoint_Operation_ReadyForWrite:
      return visit(As<TCPEndpointReadyForWriteMsg>(m), "TCP ReadyForWrite");
    case TCPEndpoint_Operation_BacklogListen:
      return visit(As<TCPEndpointBacklogListenMsg>(m), "TCP BacklogListen");
    case TCPEndpoint_Operation_Accept:
      return visit(As<TCPEndpointAcceptMsg>(m), "TCP Accept");
    case TCPEndpoint_Operation_BacklogQueues:
      return visit(As<TCPEndpointBacklogQueueMsg>(m), "TCP BacklogQueue");
    case TCPEndpoint_Operation_Address:
      return visit(As<TCPEndpointAddressMsg>(m), "TCP Address");
    default:
      return visit(As<UnknownMsg>(m), "unknown TCP operation");
  }
}

template <typename M, typename V>
void VisitUdp(M& m, V&& visit) {
  switch (m.dstOperation) {
    case UDPEndpoint_Operation_Bind:
      return visit(As<UDPEndpointBindMsg>(m), "UDP Bind");
    case UDPEndpoint_Operation_Connect:
      return visit(As<UDPEndpointConnectMsg>(m), "UDP Connect");
    case UDPEndpoint_Operation_Send:
      return visit(As<UDPEndpointSendMsg>(m), "UDP Send");
    case UDPEndpoint_Operation_Receive:
      return visit(As<UDPEndpointReceiveMsg>(m), "UDP Receive");
    case UDPEndpoint_Operation_Close:
      return visit(As<UDPEndpointCloseMsg>(m), "UDP Close");
    case UDPEndpoint_Operation_SetBlockingMode:
      return visit(As<UDPEndpointSetBlockingModeMsg>(m), "UDP SetBlockingMode");
    case UDPEndpoint_Operation_ReadyForRead:
      return visit(As<UDPEndpointReadyForReadMsg>(m), "UDP ReadyForRead");
    case UDPEndpoint_Operation_ReadyForWrite:
      return visit(As<UDPEndpointReadyForWriteMsg>(m), "UDP ReadyForWrite");
    case UDPEndpoint_Operation_Address:
      return visit(As<UDPEndpointAddressMsg>(m), "UDP Address");
    case UDPEndpoint_Operation_ResetConnect:
      return visit(As<UDPEndpointResetConnectMsg>(m), "UDP ResetConnect");
    default:
      return visit(As<UnknownMsg>(m), "unknown UDP operation");
  }
}

template <typename M, typename V>
void VisitDns(M& m, V&& visit) {
  switch (m.dstOperation) {
    case DNSEndpoint_Operation_SetServerAddresses:
      return visit(As<DNSEndpointSetServerAddressesMsg>(m), "DNS SetServerAddresses");
    case DNSEndpoint_Operation_GetServerAddresses:
      return visit(As<DNSEndpointGetServerAddressesMsg>(m), "DNS GetServerAddresses");
    case DNSEndpoint_Operation_SetDefaultDomainName:
      return visit(As<DNSEndpointSetDefaultDomainNameMsg>(m), "DNS SetDefaultDomainName");
    case DNSEndpoint_Operation_GetDefaultDomainName:
      return visit(As<DNSEndpointGetDefaultDomainNameMsg>(m), "DNS GetDefaultDomainName");
    case DNSEndpoint_Operation_GetHostByName:
      return visit(As<DNSEndpointGetHostByNameMsg>(m), "DNS GetHostByName");
    case DNSEndpoint_Operation_GetHostByAddr:
      return visit(As<DNSEndpointGetHostByAddrMsg>(m), "DNS GetHostByAddr");
    case DNSEndpoint_Operation_GetAddress:
      return visit(As<DNSEndpointGetAddressMsg>(m), "DNS GetAddress");
    case DNSEndpoint_Operation_GetAlias:
      return visit(As<DNSEndpointGetAliasMsg>(m), "DNS GetAlias");
    case DNSEndpoint_Operation_Close:
      return visit(As<DNSEndpointCloseMsg>(m), "DNS Close");
    default:
      return visit(As<UnknownMsg>(m), "unknown DNS operation");
  }
}

template <typename M, typename V>
void VisitStack(M& m, V&& visit) {
  if (m.dstSelector == Entry_antEnv_Initialize) {
    switch (m.dstOperation) {
      case antEnv_Operation_InitSetParam:
        return visit(As<antEnvInitSetParamMsg>(m), "SetParam");
      case antEnv_Operation_InitStart:
        return visit(As<antEnvInitStartMsg>(m), "Start");
      case antEnv_Operation_InitGetParam:
        return visit(As<antEnvInitGetParamMsg>(m), "GetParam");
      default:
        break;
    }
  } else if (m.dstSelector == Entry_antEnv_External) {
    switch (m.dstOperation) {
      case antEnv_Operation_CreateEndpoint:
        return visit(As<antEnvCreateEndpointMsg>(m), "CreateEndpoint");
      case antEnv_Operation_CreateSharedBuffer:
        return visit(As<antEnvCreateSharedBufferMsg>(m), "CreateSharedBuffer");
      case antEnv_Operation_DestroySharedBuffer:
        return visit(As<antEnvDestroySharedBufferMsg>(m), "DestroySharedBuffer");
      default:
        break;
    }
  }
  visit(As<UnknownMsg>(m), "unknown operation");
}

template <typename M, typename V>
void Visit(M& m, V&& visit) {
  switch (ProtocolOf(m.dstModule)) {
    case EndpointType_TCP:
      return VisitTcp(m, visit);
    case EndpointType_UDP:
      return VisitUdp(m, visit);
    case EndpointType_DNS:
      return VisitDns(m, visit);
    default:
      return VisitStack(m, visit);
  }
}

// ---- Clear() sets the numbers of received bytes and of found addresses in an answer to 0

void Clear(antEnvMsg*) {}
void Clear(TCPEndpointReceiveMsg* m) { m->sizeMin = m->sizeMax = 0; }
void Clear(UDPEndpointReceiveMsg* m) { m->size = 0; }
void Clear(DNSEndpointGetHostByNameMsg* m) { m->n_address = m->n_alias = 0; }
void Clear(DNSEndpointGetHostByAddrMsg* m) { m->n_address = m->n_alias = 0; }

// ---- AddFields() hashes the fields that only some types of messages have

void Add(Hasher* h, const IPAddress& address) { h->Add(address.Address()); }
template <size_t N>
void Add(Hasher* h, const char (&text)[N]) {
  h->AddText({text, strnlen(text, N)});
}

template <typename T>
void AddFourAddresses(Hasher* h, const T& m) {
  Add(h, m.lAddress);
  h->Add(m.lPort);
  Add(h, m.fAddress);
  h->Add(m.fPort);
}
template <typename T>
void AddHost(Hasher* h, const T& m) {
  Add(h, m.name);
  Add(h, m.server_address);
  Add(h, m.host_address);
  h->Add(m.n_address);
  h->Add(m.n_alias);
}
template <typename T>
void AddParameter(Hasher* h, const T& m) {
  Add(h, m.key);
  h->Add(m.paramType);
  if (m.paramType == antEnv_InitParam_Int32) h->Add(m.value.i32);
  if (m.paramType == antEnv_InitParam_String) Add(h, m.value.str);
}

// Adds nothing for a type of messages without an AddFields() of its own: besides operation and
// error, such messages have no fields, or fields whose meaning is not known.
void AddFields(Hasher*, const antEnvMsg&) {}

void AddFields(Hasher* h, const TCPEndpointListenMsg& m) { AddFourAddresses(h, m); }
void AddFields(Hasher* h, const TCPEndpointConnectMsg& m) { AddFourAddresses(h, m); }
void AddFields(Hasher* h, const TCPEndpointAddressMsg& m) { AddFourAddresses(h, m); }
void AddFields(Hasher* h, const TCPEndpointBindMsg& m) {
  Add(h, m.lAddress);
  h->Add(m.lPort);
}
void AddFields(Hasher* h, const TCPEndpointSendMsg& m) { h->Add(m.size); }
void AddFields(Hasher* h, const TCPEndpointReceiveMsg& m) {
  h->Add(m.sizeMin);
  h->Add(m.sizeMax);
}
void AddFields(Hasher* h, const TCPEndpointCloseMsg& m) { h->Add(m.abort); }

template <typename T>
void AddPeer(Hasher* h, const T& m) {
  Add(h, m.address);
  h->Add(m.port);
}
void AddFields(Hasher* h, const UDPEndpointBindMsg& m) { AddPeer(h, m); }
void AddFields(Hasher* h, const UDPEndpointConnectMsg& m) { AddPeer(h, m); }
void AddFields(Hasher* h, const UDPEndpointAddressMsg& m) { AddFourAddresses(h, m); }
void AddFields(Hasher* h, const UDPEndpointSendMsg& m) {
  AddPeer(h, m);
  h->Add(m.size);
}
void AddFields(Hasher* h, const UDPEndpointReceiveMsg& m) {
  AddPeer(h, m);
  h->Add(m.size);
}

template <typename T>
void AddServers(Hasher* h, const T& m) {
  h->Add(m.nscount);
  for (const IPAddress& address : m.addrList) Add(h, address);
}
void AddFields(Hasher* h, const DNSEndpointSetServerAddressesMsg& m) { AddServers(h, m); }
void AddFields(Hasher* h, const DNSEndpointGetServerAddressesMsg& m) { AddServers(h, m); }
void AddFields(Hasher* h, const DNSEndpointSetDefaultDomainNameMsg& m) { Add(h, m.name); }
void AddFields(Hasher* h, const DNSEndpointGetDefaultDomainNameMsg& m) { Add(h, m.name); }
void AddFields(Hasher* h, const DNSEndpointGetHostByNameMsg& m) { AddHost(h, m); }
void AddFields(Hasher* h, const DNSEndpointGetHostByAddrMsg& m) { AddHost(h, m); }
void AddFields(Hasher* h, const DNSEndpointGetAddressMsg& m) {
  h->Add(m.index);
  Add(h, m.address);
}
void AddFields(Hasher* h, const DNSEndpointGetAliasMsg& m) {
  h->Add(m.index);
  Add(h, m.name);
}

void AddFields(Hasher* h, const antEnvCreateEndpointMsg& m) {
  h->Add(m.protocol);
  h->Add(m.poolSize);
  h->Add(m.moduleRef.index);
}
void AddFields(Hasher* h, const antEnvCreateSharedBufferMsg& m) {
  h->Add(m.size);
  h->Add(m.buffer.GetCookie());
}
void AddFields(Hasher* h, const antEnvDestroySharedBufferMsg& m) { h->Add(m.buffer.GetCookie()); }
void AddFields(Hasher* h, const antEnvInitGetParamMsg& m) { AddParameter(h, m); }
void AddFields(Hasher* h, const antEnvInitSetParamMsg& m) { AddParameter(h, m); }

// ---- FieldsText() describes the fields that only some types of messages have

std::string Text(const IPAddress& address) {
  char text[16];
  return address.GetAsString(text);
}
template <size_t N>
std::string Text(const char (&text)[N]) {
  return fmt::format("\"{}\"", std::string_view(text, strnlen(text, N)));
}

template <typename T>
std::string FourAddresses(const T& m) {
  return fmt::format(", from {}:{} to {}:{}", Text(m.lAddress), m.lPort, Text(m.fAddress), m.fPort);
}
template <typename T>
std::string Peer(const T& m) {
  return fmt::format(", {}:{}", Text(m.address), m.port);
}
template <typename T>
std::string Servers(const T& m) {
  std::string text;
  for (int i = 0; i < m.nscount && i < MAXNS; ++i) text += ", " + Text(m.addrList[i]);
  return text;
}
template <typename T>
std::string Host(const T& m) {
  std::string text = fmt::format(", {}, {}", Text(m.name), Text(m.host_address));
  if (m.n_address > 0) text += fmt::format(", {} addresses, {} aliases", m.n_address, m.n_alias);
  return text;
}
template <typename T>
std::string Parameter(const T& m) {
  std::string text = fmt::format(", {}", Text(m.key));
  if (m.paramType == antEnv_InitParam_Int32) text += fmt::format(" is {}", m.value.i32);
  if (m.paramType == antEnv_InitParam_String) text += " is " + Text(m.value.str);
  return text;
}
const char* ProtocolName(int32_t protocol) {
  switch (protocol) {
    case EndpointType_TCP:
      return "TCP";
    case EndpointType_UDP:
      return "UDP";
    case EndpointType_DNS:
      return "DNS";
    case EndpointType_IP:
      return "IP";
    default:
      return "unknown protocol";
  }
}

std::string FieldsText(const antEnvMsg&) { return ""; }
std::string FieldsText(const TCPEndpointListenMsg& m) { return FourAddresses(m); }
std::string FieldsText(const TCPEndpointConnectMsg& m) { return FourAddresses(m); }
std::string FieldsText(const TCPEndpointAddressMsg& m) { return FourAddresses(m); }
std::string FieldsText(const TCPEndpointBindMsg& m) {
  return fmt::format(", {}:{}", Text(m.lAddress), m.lPort);
}
std::string FieldsText(const TCPEndpointSendMsg& m) { return fmt::format(", {} bytes", m.size); }
std::string FieldsText(const TCPEndpointReceiveMsg& m) {
  return m.sizeMin == m.sizeMax ? fmt::format(", {} bytes", m.sizeMin)
                                : fmt::format(", {} to {} bytes", m.sizeMin, m.sizeMax);
}
std::string FieldsText(const TCPEndpointCloseMsg& m) { return IsAbort(m) ? ", abort" : ""; }
std::string FieldsText(const UDPEndpointBindMsg& m) { return Peer(m); }
std::string FieldsText(const UDPEndpointConnectMsg& m) { return Peer(m); }
std::string FieldsText(const UDPEndpointAddressMsg& m) { return FourAddresses(m); }
std::string FieldsText(const UDPEndpointSendMsg& m) {
  return fmt::format("{}, {} bytes", Peer(m), m.size);
}
std::string FieldsText(const UDPEndpointReceiveMsg& m) {
  return fmt::format("{}, {} bytes", Peer(m), m.size);
}
std::string FieldsText(const DNSEndpointSetServerAddressesMsg& m) { return Servers(m); }
std::string FieldsText(const DNSEndpointGetServerAddressesMsg& m) { return Servers(m); }
std::string FieldsText(const DNSEndpointSetDefaultDomainNameMsg& m) { return ", " + Text(m.name); }
std::string FieldsText(const DNSEndpointGetDefaultDomainNameMsg& m) { return ", " + Text(m.name); }
std::string FieldsText(const DNSEndpointGetHostByNameMsg& m) { return Host(m); }
std::string FieldsText(const DNSEndpointGetHostByAddrMsg& m) { return Host(m); }
std::string FieldsText(const DNSEndpointGetAddressMsg& m) {
  return fmt::format(", number {}, {}", m.index, Text(m.address));
}
std::string FieldsText(const DNSEndpointGetAliasMsg& m) {
  return fmt::format(", number {}, {}", m.index, Text(m.name));
}
std::string FieldsText(const antEnvCreateEndpointMsg& m) {
  return fmt::format(", {}, pool of {} bytes{}", ProtocolName(m.protocol), m.poolSize,
                     m.moduleRef.IsNull() ? "" : fmt::format(", endpoint {}", m.moduleRef.index));
}
std::string FieldsText(const antEnvCreateSharedBufferMsg& m) {
  return fmt::format(", {} bytes", m.size);
}
std::string FieldsText(const antEnvInitGetParamMsg& m) { return Parameter(m); }
std::string FieldsText(const antEnvInitSetParamMsg& m) { return Parameter(m); }

}  // namespace

antModuleRef MakeModuleRef(int32_t protocol, uint32_t index) {
  antModuleRef ref;
  ref.module = reinterpret_cast<void*>(static_cast<uintptr_t>(protocol));
  ref.index = index;
  return ref;
}

int32_t ProtocolOf(const antModuleRef& ref) {
  const auto protocol = reinterpret_cast<uintptr_t>(ref.module);
  return protocol <= EndpointType_MIB_ETHERNET ? static_cast<int32_t>(protocol) : 0;
}

size_t AntMessageSize(const antEnvMsg& message) {
  size_t size = 0;
  Visit(message, [&](const auto& m, const char*) { size = sizeof m; });
  return size;
}

const char* AntMessageName(const antEnvMsg& message) {
  const char* result = "";
  Visit(message, [&](const auto&, const char* name) { result = name; });
  return result;
}

std::string AntMessageText(const antEnvMsg& message, bool is_answer) {
  std::string text;
  Visit(message, [&](const auto& m, const char* name) {
    text = name;
    if (!m.dstModule.IsNull()) text += fmt::format(", endpoint {}", m.dstModule.index);
    text += FieldsText(m);
    if (!is_answer) return;
    std::ostringstream error;
    error << m.error;
    text += ", " + error.str();
  });
  return text;
}

void SetAntError(antEnvMsg* message, int32_t error) {
  Visit(*message,
        [error](auto& m, const char*) { m.error = static_cast<decltype(m.error)>(error); });
}

void ClearCounts(antEnvMsg* message) {
  Visit(*message, [](auto& m, const char*) { Clear(&m); });
}

bool IsAbort(const TCPEndpointCloseMsg& message) {
  unsigned char value;
  std::memcpy(&value, &message.abort, sizeof value);
  return value != 0;
}

AntData DataToSend(const antEnvMsg& message) {
  if (message.dstSelector != Entry_antEnv_External) return {};
  const int32_t protocol = ProtocolOf(message.dstModule);
  if (protocol == EndpointType_TCP && message.dstOperation == TCPEndpoint_Operation_Send) {
    const auto& send = static_cast<const TCPEndpointSendMsg&>(message);
    return {send.buffer, send.size};
  }
  if (protocol == EndpointType_UDP && message.dstOperation == UDPEndpoint_Operation_Send) {
    const auto& send = static_cast<const UDPEndpointSendMsg&>(message);
    return {send.buffer, send.size};
  }
  return {};
}

AntBuffer BufferOf(antEnvMsg* message) {
  if (message->dstSelector != Entry_antEnv_External) return {};
  const int32_t protocol = ProtocolOf(message->dstModule);
  const int32_t operation = message->dstOperation;
  if (protocol == EndpointType_TCP && operation == TCPEndpoint_Operation_Send) {
    auto& m = static_cast<TCPEndpointSendMsg&>(*message);
    return {&m.buffer, m.size, 0};
  }
  if (protocol == EndpointType_TCP && operation == TCPEndpoint_Operation_Receive) {
    auto& m = static_cast<TCPEndpointReceiveMsg&>(*message);
    return {&m.buffer, 0, m.sizeMax};
  }
  if (protocol == EndpointType_UDP && operation == UDPEndpoint_Operation_Send) {
    auto& m = static_cast<UDPEndpointSendMsg&>(*message);
    return {&m.buffer, m.size, 0};
  }
  if (protocol == EndpointType_UDP && operation == UDPEndpoint_Operation_Receive) {
    auto& m = static_cast<UDPEndpointReceiveMsg&>(*message);
    return {&m.buffer, 0, m.size};
  }
  return {};
}

uint64_t AntMessageHash(const antEnvMsg& message, const void* data, size_t size) {
  Hasher hasher;
  hasher.Add(message.dstSelector);
  hasher.Add(ProtocolOf(message.dstModule));
  hasher.Add(message.dstModule.index);
  hasher.Add(message.dstOperation);
  hasher.Add(message.invocationType);
  Visit(message, [&](const auto& m, const char*) {
    hasher.Add(m.error);
    AddFields(&hasher, m);
  });
  hasher.AddText({static_cast<const char*>(data), size});
  const uint64_t digest = hasher.Digest();
  return digest == 0 ? 1 : digest;  // not 0, because 0 means "no hash" in a Message
}

}  // namespace openr_host
