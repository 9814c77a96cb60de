#include "openr/signal_text.h"

#include <unistd.h>

#include <cstring>

#include "runtime/core/current.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

const char* const kSystemEntries[] = {"DoInit", "DoStart", "DoStop", "DoDestroy"};

// Looking into the object's tables is safe while its own code runs: the runtime, which may be
// changing them, does not.
const char* EntryOf(const Object& object, uint32_t selector) {
  if (selector < 4) return kSystemEntries[selector];
  if (!t_current.image_code) return "";
  const auto service = object.services.find(selector);
  if (service != object.services.end()) return service->second.c_str();
  const auto extra = object.entry_names.find(selector);
  return extra == object.entry_names.end() ? "" : extra->second.c_str();
}

}  // namespace

SignalText& SignalText::Add(const char* text) {
  for (; *text != 0 && size_ < sizeof text_; ++text) text_[size_++] = *text;
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

void SignalText::WriteTo(int descriptor) const {
  for (size_t done = 0; done < size_;) {
    const ssize_t written = write(descriptor, text_ + done, size_ - done);
    if (written <= 0) return;
    done += static_cast<size_t>(written);
  }
}

void SignalText::WriteAsJsonTo(int descriptor) const {
  if (descriptor < 0) return;
  SignalText json;
  json.Add("{\"error\":\"");
  size_t end = size_;
  while (end > 0 && text_[end - 1] == '\n') --end;
  constexpr size_t kTail = sizeof "\\n\"}\n";  // the longest character and what closes the object
  for (size_t i = 0; i < end && json.size_ + kTail <= sizeof json.text_; ++i) {
    const char c[] = {text_[i], 0};
    if (*c == '\n') {
      json.Add("\\n");
    } else if (static_cast<unsigned char>(*c) >= 0x20) {
      json.Add(*c == '"' || *c == '\\' ? "\\" : "").Add(c);
    }
  }
  json.Add("\"}\n").WriteTo(descriptor);
}

bool AddCurrentHandler(SignalText* text) {
  const System* const system = t_current.system;
  const Object* const object = t_current.object;
  if (system == nullptr || object == nullptr) return false;
  text->Add(object->name.c_str());
  if (object->running == nullptr) {
    text->Add(", constructors of its globals");
  } else {
    const char* const entry = EntryOf(*object, object->running->selector);
    text->Add(", ").Add(entry).Add(*entry == 0 ? "" : " ");
    text->Add("(selector ").AddNumber(object->running->selector);
    text->Add("), message ").AddNumber(object->running->number);
  }
  text->Add(", t=").AddNumber(static_cast<uint64_t>(system->now_us())).Add(" us");
  return true;
}

}  // namespace openr_host
