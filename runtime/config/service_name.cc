#include "runtime/config/service_name.h"

#include <fmt/format.h>

#include <vector>

namespace openr_host {
namespace {

constexpr size_t kPartCount = 4;

struct Part {
  std::string_view text;
  int offset = 0;
};

std::vector<Part> SplitAtDots(std::string_view text) {
  std::vector<Part> parts;
  size_t start = 0;
  while (true) {
    const size_t dot = text.find('.', start);
    parts.push_back({text.substr(start, dot - start), static_cast<int>(start)});
    if (dot == std::string_view::npos) return parts;
    start = dot + 1;
  }
}

// Returns the first reason why `text` is not a service name.  If `text` is a service name, the
// message of the result is empty.  `parts` are the parts of `text` between its dots.
ServiceNameFault FindFault(std::string_view text, const std::vector<Part>& parts) {
  if (parts.size() != kPartCount) {
    return {fmt::format("'{}' has {} part{}, a service name has 4: Object.Service.Data.S for a "
                        "subject, .O for an observer",
                        text, parts.size(), parts.size() == 1 ? "" : "s"),
            0};
  }
  for (const Part& part : parts) {
    if (!part.text.empty()) continue;
    return {
        fmt::format("'{}' has an empty part; a service name is Object.Service.Data.S or .O", text),
        part.offset};
  }
  const Part& last = parts.back();
  if (last.text == "S" || last.text == "O") return {};
  const char* remedy = last.text == "s"                       ? "; did you mean '.S'?"
                       : last.text == "o" || last.text == "0" ? "; did you mean '.O'?"
                                                              : "";
  return {fmt::format("'{}' ends in '.{}'; a subject ends in '.S', an observer in '.O'{}", text,
                      last.text, remedy),
          last.offset};
}

}  // namespace

std::optional<ServiceName> ParseServiceName(std::string_view text, ServiceNameFault* fault) {
  const std::vector<Part> parts = SplitAtDots(text);
  ServiceNameFault found = FindFault(text, parts);
  if (!found.message.empty()) {
    if (fault != nullptr) *fault = std::move(found);
    return std::nullopt;
  }
  return ServiceName{std::string(parts[0].text), std::string(parts[1].text),
                     std::string(parts[2].text), parts[3].text[0]};
}

std::string Compose(const ServiceName& name) {
  return fmt::format("{}.{}.{}.{}", name.object, name.short_name, name.data, name.direction);
}

bool DifferInDataOnly(const ServiceName& one, const ServiceName& other) {
  return one.object == other.object && one.short_name == other.short_name &&
         one.direction == other.direction && one.data != other.data;
}

}  // namespace openr_host
