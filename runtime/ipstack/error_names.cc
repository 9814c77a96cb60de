// Names of the errors of the network stack and of the wireless card.  Functions that print network
// addresses as text.
#include <DNSEndpointErr.h>
#include <EtherTypes.h>
#include <IPEndpointMsg.h>
#include <IPv4Types.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <antErrors.h>
#include <fmt/format.h>

#include <cstddef>

namespace {

// Names of the errors of the network stack.  In this array and in the arrays below, the index of a
// name is the value of the error's constant.
constexpr const char* kAntErrors[] = {
    "ANT_SUCCESS",
    "ANT_FAIL",
    "ANT_NOMEMORY",
    "ANT_INVALIDPTR",
    "ANT_NO_STATE_TRANSITION",
    "ANT_SDU_BADRANGE",
    "ANT_SDU_NOMORE_DATACELL",
    "ANT_SDU_NOOWNER",
    "ANT_SDUPOOL_ALLOCATED",
    "ANT_SDUPOOL_NOTASSIGNED",
    "ANT_QUEUE_EMPTY",
    "ANT_QUEUE_STATE",
    "ANT_QUEUE_CLOSED",
    "ANT_QUEUE_REJECTED",
    "ANT_QUEUE_BLOCKED",
    "ANT_INVALIDMODULEID",
    "ANT_TMR_TYPE_INVALID",
    "ANT_TMR_MAXNMBR_REACHED",
    "ANT_NOMESSAGES",
    "ANT_NAMING_ENTRY_EXISTS",
    "ANT_NAMING_NO_SUCH_NAME",
    "ANT_NAMING_NAME_INVALID",
    "ANT_REGISTRY_DUPLICATE_KEY",
    "ANT_REGISTRY_NO_KEY",
    "ANT_REGISTRY_WRONG_TYPE",
    "ANT_REGISTRY_INVALID_KEY",
    "ANT_REGISTRY_INVALID_VALUE",
    "ANT_ENDPOINT_NOFACTORY",
    "ANT_NOT_INITIALIZED",
    "ANT_INITIALIZING",
};

constexpr const char* kEtherStatuses[] = {
    "ETHER_OK",
    "ETHER_UNSUPPORTED",
    "ETHER_NO_MEMORY",
    "ETHER_INVALID_PROTOCOL",
    "ETHER_INVALID_ADDRESS",
    "ETHER_INVALID_PORT",
    "ETHER_INVALID_ATTR",
    "ETHER_NO_CLIENT_ENTRY",
    "ETHER_INVALID_HANDLE",
    "ETHER_RCV_IDLE",
    "ETHER_RCV_BUSY",
    "ETHER_NO_ADDRESS_ENTRY",
    "ETHER_NO_DEVICE",
};

constexpr const char* kIpv4Errors[] = {
    "IPV4_SUCCESS",
    "IPV4_FAIL",
    "IPV4_NOMEMORY",
    "IPV4_ADDRESSINUSE",
    "IPV4_ADDRESSERROR",
    "IPV4_INVALID_REQUEST",
    "IPV4_CONNECTION_CLOSED",
    "IPV4_CONNECTION_BUSY",
    "IPV4_CONNECTION_RESET",
    "IPV4_CONNECTION_TIMEOUT",
    "IPV4_NETWORK_UNREACHABLE",
    "IPV4_HOST_UNREACHABLE",
    "IPV4_PROTOCOL_UNREACHABLE",
    "IPV4_PORT_UNREACHABLE",
    "IPV4_MESSAGE_TOO_LONG",
    "IPV4_TIME_EXCEEDED",
    "IPV4_TTL_EXCEEDED",
};

constexpr const char* kTcpErrors[] = {
    "TCP_SUCCESS",
    "TCP_FAIL",
    "TCP_CONNECTION_CLOSED",
    "TCP_CONNECTION_RESET",
    "TCP_CONNECTION_TIMEOUT",
    "TCP_CONNECTION_BUSY",
    "TCP_ADDRESSINUSE",
    "TCP_ADDRESSERROR",
    "TCP_PORT_UNREACHABLE",
    "TCP_PROTOCOL_UNREACHABLE",
    "TCP_HOST_UNREACHABLE",
    "TCP_NETWORK_UNREACHABLE",
    "TCP_MESSAGE_TOO_LONG",
    "TCP_TTL_EXCEEDED",
    "TCP_TIME_EXCEEDED",
    "TCP_WOULDBLOCK",
    "TCP_BUFFER_INVALID",
    "TCP_OPERATION_INVALID",
    "TCP_OPERATION_UNKNOWN",
};

constexpr const char* kUdpErrors[] = {
    "UDP_SUCCESS",           "UDP_FAIL",
    "UDP_CONNECTION_CLOSED", "UDP_CONNECTION_BUSY",
    "UDP_ADDRESSINUSE",      "UDP_ADDRESSERROR",
    "UDP_PORT_UNREACHABLE",  "UDP_PROTOCOL_UNREACHABLE",
    "UDP_HOST_UNREACHABLE",  "UDP_NETWORK_UNREACHABLE",
    "UDP_MESSAGE_TOO_LONG",  "UDP_TTL_EXCEEDED",
    "UDP_TIME_EXCEEDED",     "UDP_BUFFER_INVALID",
    "UDP_OPERATION_INVALID", "UDP_OPERATION_UNKNOWN",
    "UDP_WOULDBLOCK",
};

constexpr const char* kIpErrors[] = {
    "IP_SUCCESS",           "IP_FAIL",
    "IP_INVALID_PROTOCOL",  "IP_PACKETSIZE",
    "IP_CONNECTION_CLOSED", "IP_CONNECTION_BUSY",
    "IP_BUFFER_INVALID",    "IP_OPERATION_INVALID",
    "IP_OPERATION_UNKNOWN",
};

constexpr const char* kDnsErrors[] = {
    "DNS_SUCCESS",       "DNS_FAIL",           "DNS_HOST_NOT_FOUND",    "DNS_TRY_AGAIN",
    "DNS_NO_RECOVERY",   "DNS_NO_DATA",        "DNS_CONNECTION_CLOSED", "DNS_CONNECTION_BUSY",
    "DNS_INDEX_INVALID", "DNS_BUFFER_INVALID", "DNS_OPERATION_INVALID", "DNS_OPERATION_UNKNOWN",
};

template <size_t N>
const char* NameOf(int value, const char* const (&names)[N], const char* unknown) {
  return value >= 0 && value < static_cast<int>(N) ? names[value] : unknown;
}

}  // namespace

const char* antErrorString(antError error) { return NameOf(error, kAntErrors, "unknown antError"); }

const char* EtherStatusText(int status) {
  return NameOf(status, kEtherStatuses, "unknown EtherStatus");
}

std::ostream& operator<<(std::ostream& out, antError error) { return out << antErrorString(error); }

std::ostream& operator<<(std::ostream& out, EtherStatus status) {
  return out << EtherStatusText(status);
}

std::ostream& operator<<(std::ostream& out, IPv4Error error) {
  return out << NameOf(error, kIpv4Errors, "unknown IPv4Error");
}

std::ostream& operator<<(std::ostream& out, TCPEndpointError error) {
  return out << NameOf(error, kTcpErrors, "unknown TCPEndpointError");
}

std::ostream& operator<<(std::ostream& out, UDPEndpointError error) {
  return out << NameOf(error, kUdpErrors, "unknown UDPEndpointError");
}

std::ostream& operator<<(std::ostream& out, IPEndpointError error) {
  return out << NameOf(error, kIpErrors, "unknown IPEndpointError");
}

std::ostream& operator<<(std::ostream& out, DNSEndpointError error) {
  return out << NameOf(error, kDnsErrors, "unknown DNSEndpointError");
}

std::ostream& operator<<(std::ostream& out, const EtherMACAddress& address) {
  const byte* const o = address.octet;
  return out << fmt::format("{:02x}:{:02x}:{:02x}:{:02x}:{:02x}:{:02x}", o[0], o[1], o[2], o[3],
                            o[4], o[5]);
}
