#include "runtime/core/host_addresses.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <string>

#include "runtime/core/memory_tools.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The range of the addresses that the kernel gives to the host's own memory: programs, their heaps
// and libraries.  The range begins at 17 TiB, above the memory of objects (address_plan.h), and
// ends at 128 TiB, where the addresses of a program end.
constexpr uint64_t kLowest = uint64_t{0x1100} << 32;
constexpr uint64_t kEnd = uint64_t{1} << 47;

// In a build with AddressSanitizer or ThreadSanitizer, messages are not searched for addresses of
// the host's memory.  These tools reserve so much memory that many numbers look like addresses in
// it.  And with these tools, the memory of objects has no planned addresses, so the objects' own
// addresses would be taken for host addresses.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSearched = false;
#else
constexpr bool kIsSearched = true;
#endif

// Returns whether `word` lies in the range of host addresses.  For a word below kLowest the
// subtraction gives a very large number, so one comparison is enough.
bool MayBeAddress(uint64_t word) { return word - kLowest < kEnd - kLowest; }

// Returns whether memory is mapped at `address`.  mincore() answers with one short system call; the
// list of all ranges, /proc/self/maps, would take a thousand times as long to read.
bool HasMemory(uint64_t address) {
  static const uint64_t page_bytes = static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  unsigned char is_resident = 0;
  void* const page = reinterpret_cast<void*>(address / page_bytes * page_bytes);
  return mincore(page, 1, &is_resident) == 0;
}

// Describes for a finding what sent `message`: "the subject 'A.B.C.S'" for a notification, "an
// answer" for a reply.  A message of any other kind has no subject, so the text names the entry to
// which the message goes: "a message to JointMover, Move (Notify)".
std::string SenderOf(const Message& message, const Object& sender) {
  if (message.is_reply) return "an answer";
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (const auto& subject : sender.subjects()) {
      if (subject->id == notify.subjectID) return fmt::format("the subject '{}'", subject->service);
    }
  }
  const Object* const target = sender.system->object(message.target);
  return fmt::format(
      "a message to {}",
      target == nullptr ? "nobody"
                        : fmt::format("{}, {}", target->name, target->EntryName(message.selector)));
}

}  // namespace

bool HostAddresses::IsMapped(uint64_t address) {
  if (HasMemory(address)) return true;
  ++misses_;
  return false;
}

int64_t HostAddresses::FindIn(const void* data, size_t size) {
  if (!kIsSearched || IsAddressSanitized() || misses_ >= kMissesMax) return -1;
  const auto* const bytes = static_cast<const char*>(data);
  for (size_t at = 0; at + sizeof(uint64_t) <= size; at += sizeof(uint64_t)) {
    uint64_t word;
    std::memcpy(&word, bytes + at, sizeof word);
    if (MayBeAddress(word) && IsMapped(word)) return static_cast<int64_t>(at);
  }
  return -1;
}

void HostAddresses::Report(const Message& message) {
  const Object& sender = *t_current.object;
  if (sender.system->object(message.target) == nullptr) return;
  const ApiScope scope;
  int64_t offset = -1;
  int datum = 0;
  if (message.kind == PayloadKind::kNotify) {
    const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
    for (; datum < notify.numOfData; ++datum) {
      const RCRegion* const region = notify.data[datum].srcRCR;
      offset = FindIn(region->Base(), notify.data[datum].size);
      if (offset >= 0) break;
    }
  } else if (message.kind == PayloadKind::kBytes) {
    offset = FindIn(message.payload, message.size);
  }
  if (offset < 0) return;
  std::string where = fmt::format("{} sends an address of this process at offset {}",
                                  SenderOf(message, sender), offset);
  if (datum > 0) where += fmt::format(" of datum {}", datum);
  sender.system->AddFinding(
      Severity::kWarning,
      where + "; each run has another one there, and other hashes (docs/cli.md, Equal runs)");
}

}  // namespace openr_host
