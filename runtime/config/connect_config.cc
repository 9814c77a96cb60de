#include "runtime/config/connect_config.h"

#include <fmt/format.h>

#include <optional>

#include "runtime/config/line_file.h"

namespace openr_host {
namespace {

std::optional<ServiceName> ReadName(const RecordLine& line, const Word& word,
                                    std::vector<Diagnostic>* diagnostics) {
  if (word.text.size() > static_cast<size_t>(kServiceNameBytesMax)) {
    diagnostics->push_back(
        ErrorAt(line.At(word), fmt::format("service name of {} characters, the limit is {}",
                                           word.text.size(), kServiceNameBytesMax)));
    return std::nullopt;
  }
  ServiceNameFault fault;
  std::optional<ServiceName> name = ParseServiceName(word.text, &fault);
  if (!name) {
    diagnostics->push_back(
        ErrorAt(AtColumn(line.place, word.column + fault.offset), fault.message));
  }
  return name;
}

// Returns true if a line of CONNECT.CFG has exactly two words, a subject and an observer.
// Otherwise reports an error.
bool HasTwoNames(const RecordLine& line, std::vector<Diagnostic>* diagnostics) {
  if (line.words.size() == 2) return true;
  if (line.words.size() == 1) {
    diagnostics->push_back(
        ErrorAt(line.place, fmt::format("'{}' stands alone; write a subject and an observer, "
                                        "separated by a blank",
                                        line.words[0].text)));
  } else {
    diagnostics->push_back(
        ErrorAt(line.At(line.words[2]),
                fmt::format("'{}' after the two services; a line holds one subject and one "
                            "observer",
                            line.words[2].text)));
  }
  return false;
}

// Returns true if `line` names first a subject and then an observer, and both have the same data
// type.  Otherwise reports an error.  `subject` and `observer` are the two words of `line`.
bool FitTogether(const RecordLine& line, const ServiceName& subject, const ServiceName& observer,
                 std::vector<Diagnostic>* diagnostics) {
  if (!subject.is_subject() && observer.is_subject()) {
    diagnostics->push_back(ErrorAt(
        line.place, "observer first, subject second; swap the two, the subject comes first"));
    return false;
  }
  if (!subject.is_subject()) {
    diagnostics->push_back(ErrorAt(
        line.place, fmt::format("'{}' is an observer; the first service of a line is a subject",
                                line.words[0].text)));
    return false;
  }
  if (observer.is_subject()) {
    diagnostics->push_back(
        ErrorAt(line.At(line.words[1]),
                fmt::format("'{}' is a subject; the second service of a line is an observer",
                            line.words[1].text)));
    return false;
  }
  if (subject.data != observer.data) {
    diagnostics->push_back(ErrorAt(
        line.At(line.words[1]),
        fmt::format("subject sends '{}', observer expects '{}'", subject.data, observer.data)));
    return false;
  }
  return true;
}

const ConnectRecord* FindConnection(const std::vector<ConnectRecord>& connections,
                                    const ServiceName& subject, const ServiceName& observer,
                                    const std::string& section) {
  for (const ConnectRecord& record : connections) {
    const bool same = record.subject == subject && record.observer == observer;
    if (same && MayBothApply(record.section, section)) return &record;
  }
  return nullptr;
}

void AddConnection(const RecordLine& line, ConnectConfig* config) {
  if (!HasTwoNames(line, &config->diagnostics)) return;
  const std::optional<ServiceName> subject = ReadName(line, line.words[0], &config->diagnostics);
  const std::optional<ServiceName> observer = ReadName(line, line.words[1], &config->diagnostics);
  if (!subject || !observer) return;
  if (!FitTogether(line, *subject, *observer, &config->diagnostics)) return;
  if (const ConnectRecord* first =
          FindConnection(config->connections, *subject, *observer, line.section)) {
    config->diagnostics.push_back(
        WarningAt(line.place, fmt::format("these two are connected already in line {}; "
                                          "connected once",
                                          first->subject_place.line)));
    return;
  }
  config->connections.push_back(
      {*subject, *observer, line.section, line.At(line.words[0]), line.At(line.words[1])});
}

}  // namespace

ConnectConfig ParseConnectConfig(const std::string& file, std::string_view text,
                                 std::string_view design, std::string_view consequence) {
  ConnectConfig config;
  for (const RecordLine& line : ReadRecords(file, text, design, &config.diagnostics)) {
    const size_t known = config.diagnostics.size();
    AddConnection(line, &config);
    for (size_t i = known; i < config.diagnostics.size(); ++i) {
      Diagnostic& diagnostic = config.diagnostics[i];
      if (diagnostic.severity == Severity::kError) diagnostic.message += consequence;
    }
  }
  return config;
}

}  // namespace openr_host
