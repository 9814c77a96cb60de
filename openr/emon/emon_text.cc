#include "openr/emon/emon_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace openr_host {
namespace {

constexpr size_t kCallsMax = 30;

CodePlace PlaceOf(const RobotCode& code, uint32_t address) {
  return {address, code.InFile(address), code.LookUp(address)};
}

// Returns the place of the call whose return address is `address`.  A call begins 8 bytes before
// its return address: the call itself comes first, then the instruction in its delay slot.
CodePlace CallBefore(const RobotCode& code, uint32_t address) { return PlaceOf(code, address - 8); }

void FindCalls(const RobotCode& code, CrashExplanation* explanation) {
  const EmonLog& log = explanation->log;
  const auto add = [&](uint32_t address) {
    if (!code.IsAfterCall(address)) return;
    explanation->has_more_calls = explanation->calls.size() == kCallsMax;
    if (!explanation->has_more_calls) explanation->calls.push_back(CallBefore(code, address));
  };
  // Leaves out register ra if it leads into the function that failed.  This function has then
  // called another function, and ra is left from that call, so ra does not name the caller of the
  // function that failed.
  const uint32_t ra = log.registers[kRobotRa].value_or(0);
  const std::string& function = explanation->place->code.function;
  if (function.empty() || code.LookUp(ra - 8).function != function) add(ra);
  const uint32_t sp = log.registers[kRobotSp].value_or(0);
  for (auto word = log.stack.lower_bound(sp); word != log.stack.end(); ++word) add(word->second);
}

// Returns the reason why the instruction that failed, or its source line, is not known; "" if both
// are known.
std::string ProblemOf(const CrashExplanation& explanation, const RobotCode& code) {
  const EmonLog& log = explanation.log;
  if (!log.epc) return "the log has no epc, the address of the instruction that failed";
  if (!explanation.place && log.epc == log.bad_address)
    return "the program jumped to an address that is no code: a pointer to a function, a virtual "
           "table or a return address was overwritten";
  if (!explanation.place)
    return "the instruction that failed is not in this image: the image is that of another object "
           "or of another build";
  if (code.names().empty())
    return "the image has no names of functions; give the ELF file from which mkbin made it "
           "(NAME.nosnap.elf), or put that file beside the image, with the image's name";
  if (explanation.place->code.line.empty())
    return "this function has no line: it is in a library, or was compiled without -g";
  return "";
}

std::string TextOf(const CodePlace& place) {
  std::string text = fmt::format("0x{:08x}, 0x{:x} in the image", place.address, place.in_file);
  if (!place.code.function.empty()) text += "  " + place.code.function;
  if (!place.code.line.empty()) text += fmt::format(" ({})", place.code.line);
  return text;
}

nlohmann::ordered_json JsonOf(const CodePlace& place) {
  return {{"address", place.address},
          {"in_image", place.in_file},
          {"function", place.code.function},
          {"line", place.code.line}};
}

}  // namespace

CrashExplanation ExplainCrash(const EmonLog& log, RobotCode* code) {
  CrashExplanation explanation;
  explanation.log = log;
  if (log.code) explanation.meaning = MeaningOfException(*log.code);
  if (code == nullptr) {
    explanation.problem = "give --image to get the function and the line";
    return explanation;
  }
  if (!log.registers[kRobotGp]) {
    explanation.problem =
        "the log has no register gp, so it is not known where the robot had loaded the image";
    return explanation;
  }
  code->SetGp(*log.registers[kRobotGp]);
  const std::optional<uint32_t> failed = log.FailedAddress();
  if (failed && code->Contains(*failed)) {
    explanation.place = PlaceOf(*code, *failed);
    FindCalls(*code, &explanation);
  }
  explanation.problem = ProblemOf(explanation, *code);
  return explanation;
}

std::string ExplanationText(const CrashExplanation& explanation) {
  const EmonLog& log = explanation.log;
  std::string text;
  if (log.code) text += fmt::format("EXCEPTION {}: {}\n", *log.code, explanation.meaning);
  if (log.bad_address) text += fmt::format("ADDRESS 0x{:08x}\n", *log.bad_address);
  if (const EmonLog::Object* const object = log.CrashedObject()) {
    text += fmt::format("OBJECT {} (OID 0x{:08x}", object->name, object->oid);
    if (!object->meta_space.empty()) text += ", " + object->meta_space;
    text += ")\n";
  } else if (log.context) {
    text +=
        fmt::format("OBJECT unknown: none in the list has the context 0x{:08x}\n", *log.context);
  }
  if (explanation.place) {
    text += "AT " + TextOf(*explanation.place) + "\n";
  } else if (log.epc) {
    text += fmt::format("AT 0x{:08x}\n", *log.epc);
  }
  if (!explanation.calls.empty()) text += "CALLS that may have led there, the last one first\n";
  for (const CodePlace& call : explanation.calls) text += "  " + TextOf(call) + "\n";
  if (explanation.has_more_calls) text += "  and more\n";
  if (!explanation.problem.empty()) text += fmt::format("note: {}\n", explanation.problem);
  return text;
}

nlohmann::ordered_json ExplanationJson(const CrashExplanation& explanation) {
  const EmonLog& log = explanation.log;
  nlohmann::ordered_json json;
  if (log.code) json["code"] = *log.code;
  if (log.code) json["meaning"] = explanation.meaning;
  if (log.bad_address) json["bad_address"] = *log.bad_address;
  if (log.epc) json["epc"] = *log.epc;
  if (const EmonLog::Object* const object = log.CrashedObject()) {
    json["object"] = object->name;
    json["oid"] = object->oid;
  }
  if (explanation.place) json["place"] = JsonOf(*explanation.place);
  json["calls"] = nlohmann::ordered_json::array();
  for (const CodePlace& call : explanation.calls) json["calls"].push_back(JsonOf(call));
  json["has_more_calls"] = explanation.has_more_calls;
  if (!explanation.problem.empty()) json["problem"] = explanation.problem;
  return json;
}

}  // namespace openr_host
