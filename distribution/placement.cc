#include "distribution/placement.h"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

// Returns whether `text` is a valid name.  Allows few characters, because names become DDS
// partitions, in which '*' and '?' are wildcards.
bool IsName(std::string_view text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
  });
}

// Places `object` in `process`, by an entry in `placement`.  Returns "" or the error.
std::string Add(const std::string& object, const std::string& process, Placement* placement) {
  const std::string no_name = NameProblem("process", process);
  if (!no_name.empty()) return no_name;
  const auto [known, is_new] = placement->process_of.emplace(object, process);
  if (is_new || known->second == process) return "";
  return fmt::format("{} is placed in '{}' already", object, known->second);
}

// The result of a query to the name service for the address of a host.
struct ResolvedHost {
  std::string problem;
  bool is_loopback = false;
};

ResolvedHost Resolve(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_DGRAM;
  addrinfo* list = nullptr;
  const int error = getaddrinfo(host.c_str(), nullptr, &hints, &list);
  if (error != 0) return {gai_strerror(error), false};
  ResolvedHost found;
  if (list->ai_family == AF_INET) {
    const auto* const address = reinterpret_cast<const sockaddr_in*>(list->ai_addr);
    found.is_loopback = ntohl(address->sin_addr.s_addr) >> 24 == IN_LOOPBACKNET;
  } else if (list->ai_family == AF_INET6) {
    const auto* const address = reinterpret_cast<const sockaddr_in6*>(list->ai_addr);
    found.is_loopback = IN6_IS_ADDR_LOOPBACK(&address->sin6_addr);
  }
  freeaddrinfo(list);
  return found;
}

}  // namespace

std::string NameProblem(const std::string& what, const std::string& name) {
  if (IsName(name)) return "";
  return fmt::format("'{}' is no name for a {}: up to 64 letters, digits, '_', '-' and '.'", name,
                     what);
}

std::vector<std::string> Placement::Processes() const {
  std::set<std::string> names;
  for (const auto& [object, process] : process_of) names.insert(process);
  return {names.begin(), names.end()};
}

Placement ParsePlacement(const std::string& file, std::string_view text,
                         std::vector<Diagnostic>* diagnostics) {
  Placement placement;
  for (const RecordLine& line : ReadRecords(file, text, kEveryDesign, diagnostics)) {
    if (line.words.size() != 2) {
      diagnostics->push_back(ErrorAt(line.place,
                                     "a line has two words: an object and its process, "
                                     "or @process and the address of its host"));
      continue;
    }
    const std::string& first = line.words[0].text;
    const std::string& second = line.words[1].text;
    std::string problem;
    if (first[0] != '@') {
      problem = Add(first, second, &placement);
    } else if (!placement.host_of.emplace(first.substr(1), second).second) {
      problem = fmt::format("process '{}' has a host already", first.substr(1));
    } else {
      placement.host_lines.emplace(first.substr(1), line.At(line.words[1]));
    }
    if (!problem.empty()) diagnostics->push_back(ErrorAt(line.At(line.words[1]), problem));
  }
  const std::vector<std::string> processes = placement.Processes();
  for (const auto& [process, place] : placement.host_lines) {
    if (std::find(processes.begin(), processes.end(), process) == processes.end())
      diagnostics->push_back(
          ErrorAt(AtColumn(place, 1), fmt::format("no object is placed in '{}'", process)));
  }
  return placement;
}

std::vector<Diagnostic> WrongHosts(const Placement& placement, const std::string& own_address) {
  const bool is_here = Resolve(own_address).is_loopback;
  std::vector<Diagnostic> diagnostics;
  for (const auto& [process, host] : placement.host_of) {
    const FilePosition& place = placement.host_lines.at(process);
    const ResolvedHost found = Resolve(host);
    if (!found.problem.empty()) {
      diagnostics.push_back(ErrorAt(
          place,
          fmt::format("host '{}' cannot be found ({}); give its address", host, found.problem)));
    } else if (is_here && !found.is_loopback) {
      diagnostics.push_back(ErrorAt(
          place, fmt::format("{} cannot reach this run at {}; give --dds-address, the address of "
                             "this host in the network of that one",
                             host, own_address)));
    }
  }
  return diagnostics;
}

std::string AddPlace(const std::string& text, Placement* placement) {
  const size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) return "it is OBJECT=PROCESS";
  return Add(text.substr(0, equals), text.substr(equals + 1), placement);
}

}  // namespace openr_host
