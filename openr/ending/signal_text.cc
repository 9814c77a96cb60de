#include "openr/ending/signal_text.h"

#include <OPENR/ObjcommMessages.h>

#include <algorithm>
#include <cstring>

#include "cli/output_file.h"
#include "runtime/core/current.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

const char* const kSystemEntries[] = {"DoInit", "DoStart", "DoStop", "DoDestroy"};

// Returns the name of the object's handler with the number `selector`; "" if the name is not known.
// The object's maps of names are read only if a signal has interrupted the object's own code.  If a
// signal has interrupted the runtime, the runtime may have been changing these maps.
const char* EntryOf(const Object& object, uint32_t selector) {
  if (selector < 4) return kSystemEntries[selector];
  if (!t_current.image_code) return "";
  const EntryNames& names = object.entry_names();
  if (const std::string* const service = names.FindService(selector)) return service->c_str();
  const std::string* const extra = names.FindName(selector);
  return extra == nullptr ? "" : extra->c_str();
}

// Returns the kind of `message` in words, with a blank in front, such as " notification"; "" for a
// message of kind PayloadKind::kBytes.
const char* KindInWords(const Message& message) {
  switch (message.kind) {
    case PayloadKind::kNotify:
      return " notification";
    case PayloadKind::kReady:
      switch (reinterpret_cast<const OReadyMessage*>(message.payload)->command) {
        case objcommCMD_ASSERT_READY:
          return " ready (assert)";
        case objcommCMD_DEASSERT_READY:
          return " not ready (deassert)";
        default:
          return " ready";
      }
    case PayloadKind::kHashed:
      return " request or answer of the network stack";
    case PayloadKind::kBytes:
      break;
  }
  return "";
}

// Adds the number of bytes that `message` has; for a notification, the bytes of its regions.
void AddSize(const Message& message, SignalText* text) {
  size_t size = message.size;
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    // Limits the number of the notification's regions, because the object that crashed may have
    // damaged the message.
    const int count = std::min<int>(notify.numOfData, MAX_NUM_DATA);
    size = 0;
    for (int i = 0; i < count; ++i) size += notify.data[i].size;
  }
  text->AddNumber(size).Add(size == 1 ? " byte" : " bytes");
}

}  // namespace

SignalText& SignalText::Add(std::string_view text) {
  size_ += text.copy(text_ + size_, sizeof text_ - size_);
  return *this;
}

SignalText& SignalText::AddNumber(uint64_t number, unsigned base) {
  char digits[65];
  size_t at = sizeof digits;
  digits[--at] = 0;
  do {
    digits[--at] = "0123456789abcdef"[number % base];
    number /= base;
  } while (number != 0);
  return Add(digits + at);
}

void SignalText::WriteTo(int descriptor) const { WriteAll(descriptor, text()); }

SignalText& SignalText::AddQuoted(const SignalText& text) {
  std::string_view rest = text.text();
  while (rest.ends_with('\n')) rest.remove_suffix(1);
  Add("\"");
  // Number of bytes that must be free in text_ before a character of the JSON string is added: room
  // for the longest escaped character and for the closing quote.
  constexpr size_t kTail = sizeof "\\n\"" - 1;
  for (const char c : rest) {
    if (size_ + kTail > sizeof text_) break;
    const char one[] = {c, 0};
    if (c == '\n') {
      Add("\\n");
    } else if (static_cast<unsigned char>(c) >= 0x20) {
      Add(c == '"' || c == '\\' ? "\\" : "").Add(one);
    }
  }
  return Add("\"");
}

void AddCurrentEntry(SignalText* text) {
  const Object& object = *t_current.object;
  if (object.running() == nullptr) {
    text->Add(t_current.image_code ? "constructors of its globals"
                                   : "loading or unloading of its image");
    return;
  }
  const char* const entry = EntryOf(object, object.running()->selector);
  text->Add(entry).Add(*entry == 0 ? "" : " ");
  text->Add("(selector ").AddNumber(object.running()->selector).Add(")");
}

bool AddCurrentHandler(SignalText* text) {
  const System* const system = t_current.system;
  const Object* const object = t_current.object;
  if (system == nullptr || object == nullptr) return false;
  text->Add(object->name.c_str());
  text->Add(", ");
  AddCurrentEntry(text);
  if (object->running() != nullptr) text->Add(", message ").AddNumber(object->running()->number);
  text->Add(", t=").AddNumber(static_cast<uint64_t>(system->now_us())).Add(" us");
  return true;
}

void AddCurrentMessage(SignalText* text) {
  const Object* const object = t_current.object;
  if (object == nullptr || object->running() == nullptr) return;
  const Message& message = *object->running();
  text->Add("MESSAGE").Add(KindInWords(message));
  // Looks the sender up only if a signal has interrupted the object's own code.  If a signal has
  // interrupted the runtime, the runtime may have been changing the table of objects.
  const Object* const sender =
      t_current.image_code ? t_current.system->object(message.sender) : nullptr;
  if (sender != nullptr) text->Add(" from ").Add(sender->name.c_str());
  text->Add(", ");
  AddSize(message, text);
  text->Add("\n");
}

// Writes the JSON report in several SignalTexts, because each SignalText has a fixed size.
void WriteEndingAsJson(const SignalText& record, const SignalText& finding, const char* ended_by,
                       const Current& current, int descriptor) {
  if (descriptor < 0) return;
  const Object* const object = current.object;
  SignalText error, about, name, text, end;
  error.Add("{\"error\":").AddQuoted(record).WriteTo(descriptor);
  about.Add(",\"ended_by\":\"").Add(ended_by).Add("\"");
  about.Add(",\"findings\":[{\"severity\":\"error\",\"robot\":");
  about.AddNumber(object == nullptr ? 0 : static_cast<uint64_t>(object->robot));
  about.Add(",\"object\":").AddQuoted(name.Add(object == nullptr ? "" : object->name.c_str()));
  const bool handles = object != nullptr && object->running() != nullptr;
  about.Add(",\"message\":").AddNumber(handles ? object->running()->number : 0);
  const int64_t now_us = current.system == nullptr ? 0 : current.system->now_us();
  about.Add(",\"time_s\":").AddNumber(static_cast<uint64_t>(now_us / 1'000'000)).Add(".");
  for (int64_t unit = 100'000; unit > 0; unit /= 10)
    about.AddNumber(static_cast<uint64_t>(now_us / unit % 10));
  about.Add(",\"count\":1,\"text\":").WriteTo(descriptor);
  text.AddQuoted(finding).WriteTo(descriptor);
  end.Add("}]}\n").WriteTo(descriptor);
}

}  // namespace openr_host
