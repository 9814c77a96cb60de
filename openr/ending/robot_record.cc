#include "openr/ending/robot_record.h"

#include "runtime/core/api.h"
#include "runtime/core/message.h"
#include "runtime/core/object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int kWordDigits = 8;
constexpr int kTimeDigits = 16;
constexpr unsigned kHex = 16;

// Adds the lowest `digits` hexadecimal digits of `number`, with zeros in front.
SignalText& AddHex(uint64_t number, int digits, SignalText* text) {
  text->Add("0x");
  for (int digit = digits - 1; digit >= 0; --digit) text->AddNumber(number >> 4 * digit & 15, kHex);
  return *text;
}

SignalText& AddWord(const char* name, uint64_t number, SignalText* text) {
  text->Add(name).Add(": ");
  return AddHex(number, kWordDigits, text);
}

// Adds the line about `object` to `text`, which becomes a crash record's list of objects.
void AddObject(const Object& object, SignalText* text) {
  text->Add(" ").Add(object.name.c_str());
  for (int column = 0; column < 3; ++column) {  // columns Context, Thread and OID all show the id
    text->Add(" ");
    AddHex(OidValue(object.id), kWordDigits, text);
  }
  text->Add(" mCOOP\n");
}

}  // namespace

void WriteRobotRecord(const RobotException& exception, const Object& object,
                      const std::function<void(const SignalText&)>& write) {
  SignalText text;
  text.Add(kRobotRecordBegin).Add("\n time stamp: ");
  AddHex(static_cast<uint64_t>(object.system->now_us()), kTimeDigits, &text).Add("\n ");
  AddWord("status:$12", 0, &text).Add(", ");
  AddWord("cause:$13", exception.code << 2, &text).Add("\n ");
  AddWord("badvaddr:$8", exception.bad_address, &text).Add(", ");
  AddWord("epc:$14", exception.epc, &text).Add("\n[object info]\n");
  AddWord(" context", OidValue(object.id), &text).Add("\nexception code ");
  text.AddNumber(exception.code).Add("\n[object list]\n Name Context Thread OID MetaSpace\n");
  write(text);
  if (!exception.is_in_own_code) {
    SignalText line;
    AddObject(object, &line);
    write(line);
    return;
  }
  for (const auto& each : object.system->objects()) {
    if (each->robot != object.robot || each->is_absent()) continue;
    SignalText line;
    AddObject(*each, &line);
    write(line);
  }
}

}  // namespace openr_host
