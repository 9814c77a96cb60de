#include "distribution/join_advice.h"

#include <fmt/format.h>

namespace openr_host {

std::string JoinAdvice(const std::string& process, const std::string& host, const BusOptions& bus) {
  const BusOptions assumed;
  std::string text = fmt::format("start it on {} with: openr join --process {}", host, process);
  if (bus.run != "openr") text += fmt::format(" --run-name {}", bus.run);
  if (bus.domain != assumed.domain) text += fmt::format(" --dds-domain {}", bus.domain);
  if (host != assumed.address) text += fmt::format(" --dds-address {}", host);
  if (host != bus.address) text += fmt::format(" --dds-peer {}", bus.address);
  if (bus.lease_s != assumed.lease_s) text += fmt::format(" --dds-lease {}", bus.lease_s);
  // Writes the word FILE into the command that the user is to type on the host `host`, and not the
  // name of this run's settings file.  Each host has a settings file of its own: with DDS Security,
  // the file contains the host's private key.
  if (!bus.config_file.empty()) text += " --dds-config FILE";
  if (host != bus.address)
    // Writes the word DIR into the command.  The user replaces it by the folder of a copy of the
    // run's stick on the host `host`.
    text += " --stick DIR";
  return text;
}

}  // namespace openr_host
