// The four-part names under which services are registered and connected:
// "RCServer.Move.MoveCommand.S" is object, service, data type and direction.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace openr_host {

// The length of the longest service name: oserviceNAME_MAX of <OPENR/OPENR.h>, without the closing
// NUL.
inline constexpr int kServiceNameBytesMax = 127;

struct ServiceName {
  // Name of the object in a service name, used only to find the service.  It may differ from
  // ObjectName in stub.cfg.
  std::string object;
  // Second part of the name, such as Move.  For Move, def.h has the constant sbjMove or obsMove.
  std::string short_name;
  std::string data;      // data type: any text without a dot, equal at both ends of a connection
  char direction = 'S';  // 'S': subject, 'O': observer

  bool is_subject() const { return direction == 'S'; }
  bool operator==(const ServiceName&) const = default;
};

// The reason why a text is not a service name.
struct ServiceNameFault {
  std::string message;
  int offset = 0;  // offset of the fault in the text, where messages show a caret
};

// Parses the service name `text`; upper and lower case differ.  If `text` is no service name,
// returns nullopt, and sets `*fault` to the reason unless `fault` is null.  A name that is too long
// is accepted, because callers themselves compare the length with kServiceNameBytesMax and report
// it.
std::optional<ServiceName> ParseServiceName(std::string_view text, ServiceNameFault* fault);

// Returns the service name `name` as text, the inverse of ParseServiceName().
std::string Compose(const ServiceName& name);

// Returns whether the two names have different data types and are otherwise equal.
bool DifferInDataOnly(const ServiceName& one, const ServiceName& other);

}  // namespace openr_host
