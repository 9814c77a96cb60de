// Names of the network stack's and the wireless card's results.
#include <EtherTypes.h>
#include <antErrors.h>

#include <cstddef>

namespace {

// By value, from 0.
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

template <size_t N>
const char* NameOf(int value, const char* const (&names)[N], const char* unknown) {
  return value >= 0 && value < static_cast<int>(N) ? names[value] : unknown;
}

}  // namespace

const char* antErrorString(antError error) { return NameOf(error, kAntErrors, "unknown antError"); }

const char* EtherStatusText(int status) {
  return NameOf(status, kEtherStatuses, "unknown EtherStatus");
}
