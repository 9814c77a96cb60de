#include "runtime/config/gateway_config.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "runtime/base/parse_ip_address.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// The port of the robot's wireless console (Installation Guide 3.2.1).  A service of the gateway on
// this port gets a warning, because the console already uses the port.
constexpr int kConsolePort = 59000;

// Returns true if `text` is an IPv4 address, but not 0.0.0.0, which is the address of no computer.
bool IsAddress(std::string_view text) { return ParseIpAddress(text).value_or(0) != 0; }

std::optional<uint16_t> PortOf(const Word& word) {
  int port = 0;
  const char* const end = word.text.data() + word.text.size();
  const auto [stop, error] = std::from_chars(word.text.data(), end, port);
  if (error != std::errc() || stop != end || port < 1 || port > 65535) return std::nullopt;
  return static_cast<uint16_t>(port);
}

class GatewayReader {
 public:
  GatewayReader(GatewaySide side, GatewayConfig* config) : side_(side), config_(config) {}

  void Read(const RecordLine& line) {
    const std::string& first = line.words[0].text;
    if (first == kProxyRecord || first.ends_with(".AperiosMessage.P")) return ReadProxy(line);
    if (first[0] == '!') {
      config_->diagnostics.push_back(
          WarningAt(line.place, fmt::format("'{}' is not known; there is {} only{}", first,
                                            kProxyRecord, DidYouMean(first, {kProxyRecord}))));
      return;
    }
    if (!HasWordCount(line)) return;
    GatewayRecord record;
    record.section = line.section;
    record.place = line.place;
    if (ReadService(line, &record) && ReadPort(line, &record) && ReadHost(line, &record) &&
        IsNew(line, record))
      config_->services.push_back(std::move(record));
  }

 private:
  void Refuse(const FilePosition& place, std::string why) {
    config_->diagnostics.push_back(ErrorAt(place, std::move(why) + "; the service is not there"));
  }

  // Reads the configuration line for OPEN-R calls (calls by which programs on a PC use functions of
  // the robot).  In the robot's file (ROBOTGW.CFG) the line has the port where calls arrive.  In
  // the PC's file (HOSTGW.CFG) it has the port and address to which calls are sent.
  void ReadProxy(const RecordLine& line) {
    const bool is_of_host = line.words[0].text == kProxyRecord;
    if (is_of_host != (side_ == GatewaySide::kHost)) {
      config_->diagnostics.push_back(WarningAt(
          line.place,
          fmt::format("OPEN-R calls are not carried: '{}' belongs to {}, this file has "
                      "{}",
                      line.words[0].text, is_of_host ? "the PC's file" : "the robot's file",
                      is_of_host ? fmt::format("'{} PORT'", kProxyService)
                                 : fmt::format("'{} PORT ADDRESS'", kProxyRecord))));
      return;
    }
    if (!HasWordCount(line)) return;
    GatewayRecord record;
    record.section = line.section;
    record.place = line.place;
    record.is_proxy = true;
    if (!ReadPort(line, &record) || !ReadHost(line, &record) || !IsNew(line, record)) return;
    if (config_->proxy && MayBothApply(config_->proxy->section, record.section)) {
      Refuse(line.place, fmt::format("OPEN-R calls have a port already, in line {}",
                                     config_->proxy->place.line));
      return;
    }
    config_->proxy = std::move(record);
  }

  bool HasWordCount(const RecordLine& line) {
    const size_t wanted = side_ == GatewaySide::kRobot ? 2 : 3;
    const char* const form =
        side_ == GatewaySide::kRobot ? "a service and a port" : "a service, a port and an address";
    if (line.words.size() < wanted) {
      Refuse(line.place, fmt::format("a line holds {}, separated by blanks", form));
      return false;
    }
    if (line.words.size() > wanted) {
      const std::string& word = line.words[wanted].text;
      const bool is_address = IsAddress(word);
      Refuse(line.At(line.words[wanted]),
             fmt::format("'{}' after the record; a line holds {}{}", word, form,
                         side_ == GatewaySide::kRobot && is_address
                             ? "; addresses are in the PC's HOSTGW.CFG, where a robot that openr "
                               "runs on this computer is 127.0.0.1"
                             : ""));
      return false;
    }
    return true;
  }

  bool ReadService(const RecordLine& line, GatewayRecord* record) {
    const Word& word = line.words[0];
    if (word.text.size() > static_cast<size_t>(kServiceNameBytesMax)) {
      Refuse(line.place, fmt::format("service name of {} characters, the limit is {}",
                                     word.text.size(), kServiceNameBytesMax));
      return false;
    }
    ServiceNameFault fault;
    const std::optional<ServiceName> name = ParseServiceName(word.text, &fault);
    if (name) {
      record->service = *name;
    } else {
      Refuse(AtColumn(line.place, word.column + fault.offset), fault.message);
    }
    return name.has_value();
  }

  bool ReadPort(const RecordLine& line, GatewayRecord* record) {
    const std::optional<uint16_t> port = PortOf(line.words[1]);
    if (!port) {
      Refuse(line.At(line.words[1]),
             fmt::format("'{}' is no port; write a number of 1 to 65535", line.words[1].text));
      return false;
    }
    record->port = *port;
    if (*port == kConsolePort) {
      config_->diagnostics.push_back(WarningAt(
          line.At(line.words[1]),
          fmt::format("port {} belongs to the wireless console of the robot", kConsolePort)));
    }
    return true;
  }

  bool ReadHost(const RecordLine& line, GatewayRecord* record) {
    if (side_ == GatewaySide::kRobot) return true;
    record->host = line.words[2].text;
    if (IsAddress(record->host)) return true;
    Refuse(line.At(line.words[2]),
           fmt::format("'{}' is no address; write the robot's, such as 10.0.1.100, or 127.0.0.1 "
                       "for one that runs on this computer",
                       line.words[2].text));
    return false;
  }

  // Returns true if `record` differs from each earlier line for the same robot in two points: in
  // the service, and in the port or the address.  Otherwise reports an error, because a service
  // carries only one connection, and the gateway of the other computer finds a service by its port.
  bool IsNew(const RecordLine& line, const GatewayRecord& record) {
    std::vector<GatewayRecord> all = config_->services;
    if (config_->proxy) all.push_back(*config_->proxy);
    for (const GatewayRecord& known : all) {
      if (!MayBothApply(known.section, record.section)) continue;
      if (!known.is_proxy && !record.is_proxy && known.service == record.service) {
        Refuse(line.place, fmt::format("the service is given already in line {}; it carries one "
                                       "connection",
                                       known.place.line));
        return false;
      }
      if (known.port == record.port && known.host == record.host) {
        Refuse(line.At(line.words[1]),
               fmt::format("port {} is that of '{}' in line {}; the two sides pair by port",
                           record.port, known.Name(), known.place.line));
        return false;
      }
    }
    return true;
  }

  const GatewaySide side_;
  GatewayConfig* const config_;
};

}  // namespace

std::string GatewayRecord::Name() const {
  if (!is_proxy) return Compose(service);
  return host.empty() ? kProxyService : kProxyRecord;
}

GatewayConfig ParseGatewayConfig(const std::string& file, std::string_view text,
                                 std::string_view design, GatewaySide side) {
  GatewayConfig config;
  GatewayReader reader(side, &config);
  for (const RecordLine& line : ReadRecords(file, text, design, &config.diagnostics))
    reader.Read(line);
  return config;
}

std::vector<Diagnostic> CheckGatewayWires(const ConnectConfig& wires, const GatewayConfig& gateway,
                                          const std::string& file) {
  std::vector<Diagnostic> diagnostics;
  struct Wire {
    const ServiceName& service;
    const std::string& section;
    int line;
  };
  std::vector<Wire> known;
  // Checks one end of a wire (a line of CONNECT.CFG).  The gateway must have the service that the
  // wire names, and no earlier wire may use this service, because a service of the gateway carries
  // one connection.
  const auto check = [&](const ServiceName& service, const std::string& section,
                         const FilePosition& place) {
    if (!Compose(service).starts_with(kGatewayPrefix)) return;
    std::vector<std::string> names;
    bool is_there = false;
    for (const GatewayRecord& record : gateway.services) {
      is_there = is_there || record.service == service;
      names.push_back(Compose(record.service));
    }
    if (!is_there) {
      diagnostics.push_back(
          ErrorAt(place, fmt::format("the gateway has no '{}': it is not in {}{}", Compose(service),
                                     file, DidYouMean(Compose(service), names))));
      return;
    }
    for (const Wire& wire : known) {
      if (wire.service != service || !MayBothApply(wire.section, section)) continue;
      diagnostics.push_back(ErrorAt(
          place, fmt::format("'{}' is connected already in line {}; a service of the gateway "
                             "carries one connection, more fail on the robot: give each its own "
                             "service and port",
                             Compose(service), wire.line)));
      break;
    }
    known.push_back({service, section, place.line});
  };
  for (const ConnectRecord& wire : wires.connections) {
    check(wire.subject, wire.section, wire.subject_place);
    check(wire.observer, wire.section, wire.observer_place);
  }
  return diagnostics;
}

}  // namespace openr_host
