// The four-part names under which services are registered and connected:
// "RCServer.Move.MoveCommand.S" is object, service, data type and direction.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace openr_host {

// oserviceNAME_MAX of <OPENR/OPENR.h>, without the closing NUL.
inline constexpr int kServiceNameBytesMax = 127;

struct ServiceName {
  std::string object;    // need not be the ObjectName of stub.cfg; used only to match
  std::string service;   // gives sbj<Service> or obs<Service> in def.h
  std::string data;      // any text without dot; both ends of a connection must agree
  char direction = 'S';  // 'S': subject, 'O': observer

  bool is_subject() const { return direction == 'S'; }
  bool operator==(const ServiceName&) const = default;
};

// Why a text is not a service name.
struct ServiceNameFault {
  std::string message;
  int offset = 0;  // bytes from the start of the text, for a caret
};

// Case counts.  On failure returns nullopt and fills `fault` unless that is null.
// Length is not checked, see kServiceNameBytesMax.
std::optional<ServiceName> ParseServiceName(std::string_view text, ServiceNameFault* fault);

// The inverse: ParseServiceName(Compose(n)) == n.
std::string Compose(const ServiceName& name);

// Whether both are the same service, but with other data.
bool DifferInDataOnly(const ServiceName& one, const ServiceName& other);

}  // namespace openr_host
