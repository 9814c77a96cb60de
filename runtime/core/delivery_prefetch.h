// PrefetchDeliveries(): loads what the next deliveries need into the processor's cache.
#pragma once

#include <cstdint>

#include "runtime/core/code_object.h"
#include "runtime/core/message.h"
#include "runtime/core/object.h"
#include "runtime/core/object_table.h"

namespace openr_host {

// Loads `count` lines of the cache, beginning with the line of `address`.  Any number is allowed as
// an address, 0 too, because the processor ignores a prefetch of memory that does not exist.
[[gnu::always_inline]] inline void PrefetchLines(uintptr_t address, unsigned count = 1) {
  // Prevents g++ from removing calls of this function.  g++ removes calls of functions that only
  // prefetch, because it sees no effect of such functions.
  asm volatile("");
  constexpr unsigned kLineBytes = 64;
  for (unsigned line = 0; line < count; ++line)
    __builtin_prefetch(reinterpret_cast<const void*>(address + kLineBytes * line));
}
[[gnu::always_inline]] inline void PrefetchLines(const void* address, unsigned count = 1) {
  PrefetchLines(reinterpret_cast<uintptr_t>(address), count);
}

// Loads into the cache what the next deliveries need: the deliveries of the messages after
// `message` in its list of the MessageQueue.  Without this, a run with thousands of objects spends
// most of its time waiting for memory.
//
// A delivery reads a chain of five records: the message, its receiver, the receiver's table of
// entries, the entry, the state of the subject or observer.  The address of each record is known
// only when the record before it has been read.  So each call loads one record for each of the next
// five messages: for the fifth message the first record, for the fourth the second record, and so
// on.
//
// Does nothing if fewer than four messages follow, because a run with few messages uses few
// objects, which are in the cache already.
[[gnu::always_inline]] inline void PrefetchDeliveries(const Message& message,
                                                      const ObjectTable& objects) {
  const Message* const first = message.next;
  const Message* const second = first == nullptr ? nullptr : first->next;
  const Message* const third = second == nullptr ? nullptr : second->next;
  const Message* const fourth = third == nullptr ? nullptr : third->next;
  if (fourth == nullptr) return;
  const auto entry_of = [&objects](const Message* each) {
    return FindCodeEntry(*objects.GetKnown(each->target), each->selector);
  };

  if (const CodeEntry* const entry = entry_of(first)) {
    if (entry->subject_state != nullptr) PrefetchLines(entry->subject_state, 2);
    if (entry->observer_state != nullptr) PrefetchLines(entry->observer_state, 2);
  }
  PrefetchLines(entry_of(second));
  PrefetchLines(reinterpret_cast<uintptr_t>(objects.GetKnown(third->target)->code_entries()) +
                sizeof(void*) * uintptr_t{third->selector - oentryBASE});
  const Object* const receiver = objects.GetKnown(fourth->target);
  PrefetchLines(receiver);
  PrefetchLines(receiver->delivery_line());
  PrefetchLines(fourth->next, 3);
}

}  // namespace openr_host
