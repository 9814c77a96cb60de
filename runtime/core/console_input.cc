#include "runtime/core/console_input.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

namespace openr_host {

size_t ConsoleInput::RoomOf(int robot) const {
  size_t used = 0;
  if (const auto found = terminals_.find(robot); found != terminals_.end())
    used += found->second.text.size();
  if (const auto found = reserved_.find(robot); found != reserved_.end()) used += *found->second;
  return kUnreadMax - std::min(used, kUnreadMax);
}

bool ConsoleInput::HasReader(int robot) const {
  const auto found = terminals_.find(robot);
  return found != terminals_.end() && found->second.has_reader;
}

std::shared_ptr<const void> ConsoleInput::Reserve(int robot, size_t bytes) {
  std::shared_ptr<size_t>& reserved = reserved_[robot];
  if (reserved == nullptr) reserved = std::make_shared<size_t>(0);
  *reserved += bytes;
  return std::shared_ptr<const void>(reserved.get(),
                                     [reserved, bytes](const void*) { *reserved -= bytes; });
}

void ConsoleInput::Enter(int robot, std::string_view text) {
  Terminal& terminal = terminals_[robot];
  terminal.text += text;
  if (!text.ends_with('\n')) terminal.text += '\n';
  WakeNext(&terminal);
}

// Wakes the handler that has waited longest for a line from `terminal`.  The list of readers may
// still name objects that were reloaded while they waited.  Their handlers have ended, so they are
// skipped.
void ConsoleInput::WakeNext(Terminal* terminal) {
  while (!terminal->readers.empty()) {
    const auto [id, box] = terminal->readers.front();
    terminal->readers.pop_front();
    const Object* const object = system_->object(id);
    if (object == nullptr || object->delivery().blocked() == nullptr || object->wait().box() != box)
      continue;
    // The message that wakes the reader (an object that waits for a line of the console) also holds
    // the line, so that the trace shows it.  The reader takes the line from the terminal and not
    // from this message.
    OwnedMessage wake = system_->NewMessage(id, 0);
    wake->message_class = MessageClass::kInput;
    wake->is_reply = true;
    wake->reply_box = box;
    const size_t line = std::min(terminal->text.find('\n') + 1, Message::kPayloadMax);
    std::memcpy(wake->payload, terminal->text.data(), line);
    wake->size = static_cast<uint32_t>(line);
    system_->Post(std::move(wake));
    return;
  }
}

// Ends the wait of object `reader` for a line, because the process of the object has ended.  If
// WakeNext() has already woken `reader` for a line, the object can no longer read this line.  In
// this case wakes the next reader for the line.
void ConsoleInput::GiveUp(Terminal* terminal, ObjectId reader, uint64_t box) {
  const bool waited = std::erase(terminal->readers, std::pair(reader, box)) > 0;
  if (!waited && !terminal->text.empty()) WakeNext(terminal);
}

size_t ConsoleInput::Read(char* buffer, size_t size, const std::function<bool()>& is_gone) {
  Object* const self = t_current.object;
  ASSERT(self != nullptr, "only a handler reads the console");
  Terminal& terminal = terminals_[self->robot];
  terminal.has_reader = true;
  // Waits again until the terminal has text, because another reader may take the line after this
  // reader was woken and before it runs.
  while (terminal.text.empty()) {
    const uint64_t box = system_->requests().OpenBox();
    terminal.readers.emplace_back(self->id, box);
    system_->requests().Wait(box, nullptr, 0, nullptr, -1, kWaitReason);
    if (is_gone && is_gone()) {
      GiveUp(&terminal, self->id, box);
      return 0;
    }
  }
  const size_t line = terminal.text.find('\n') + 1;
  const size_t count = std::min(line, size);
  std::memcpy(buffer, terminal.text.data(), count);
  if (echo_) system_->Print(terminal.text.substr(0, count));
  terminal.text.erase(0, count);
  if (!terminal.text.empty()) WakeNext(&terminal);
  return count;
}

void ConsoleInput::HashState(Hasher* hasher) const {
  for (const auto& [robot, terminal] : terminals_) {
    hasher->Add(robot);
    hasher->AddText(terminal.text);
    for (const auto& [id, box] : terminal.readers) hasher->Add(id);
  }
}

}  // namespace openr_host
