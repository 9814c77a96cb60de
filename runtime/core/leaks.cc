#include "runtime/core/leaks.h"

#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "runtime/core/address_plan.h"
#include "runtime/core/code_place.h"
#include "runtime/core/memory_map.h"
#include "runtime/core/object.h"
#include "runtime/core/rcregion_pool.h"
#include "runtime/core/stack_memory.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// An address in the tables of this file, hidden from the search for leaks: stored with some bits
// changed.  The search reads all memory of this process, also these tables, but must not find
// addresses of blocks in the tables.
class HiddenAddress {
 public:
  HiddenAddress() = default;
  explicit HiddenAddress(const void* address)
      : hidden_(reinterpret_cast<uintptr_t>(address) ^ kMask) {}
  uintptr_t value() const { return hidden_ ^ kMask; }
  const char* pointer() const { return reinterpret_cast<const char*>(value()); }

 private:
  // An address is stored as its XOR with this mask.  The mask sets upper bits that are 0 in every
  // address, so the search for leaks never takes the stored number for an address.
  static constexpr uintptr_t kMask = 0xa5a5'0000'0000'0000;
  uintptr_t hidden_ = kMask;
};

// A block or a region that may have leaked.  The search reads its bytes only if the block or region
// is reachable itself.
struct Node {
  HiddenAddress begin;
  size_t bytes = 0;
  // Owner of the block or region; null if the block or region must never be reported as a leak.
  const Object* object = nullptr;
  bool is_region = false;
  // The calls that led to the allocation of a block; null for a region.
  const std::vector<const void*>* calls = nullptr;
  const void* made_at = nullptr;  // the instruction that made the region; null for a block
  bool is_reachable = false;
};

struct Range {
  HiddenAddress begin;
  size_t bytes = 0;
};

class LeakSearch {
 public:
  explicit LeakSearch(System* system) : system_(system) {}

  // Marks all reachable nodes (blocks and regions).  `stack` is the lowest address of this thread's
  // stack that is searched.
  void Run(const char* stack);
  void Report() const;

 private:
  void CollectBlocks();
  void CollectRegions();
  void CollectPool();
  void ReadStacks();
  void ReadHost(const char* stack);
  void ReadAround(const char* begin, const char* end);
  // Searches the words of the memory from `begin` to `end`.  If a word is an address in a node (a
  // block or region), marks this node as reachable.  With `has_ids`, also marks each region whose
  // id is in a word.
  void Read(const char* begin, const char* end, bool has_ids);
  void ReadReached();
  void MarkAddress(uintptr_t address);
  void MarkId(uint32_t id);
  void Mark(size_t node);
  bool HasWaitingHandler() const;

  System* const system_;
  std::vector<Node> nodes_;   // the blocks and regions, in the order of addresses
  std::vector<Range> holes_;  // memory of this process that is not read, in the order of addresses
  std::map<uint32_t, HiddenAddress> region_of_id_;
  std::vector<size_t> reached_;  // indices of reachable nodes whose bytes have still to be searched
};

bool IsLess(const HiddenAddress& a, const HiddenAddress& b) { return a.value() < b.value(); }

void LeakSearch::CollectBlocks() {
  for (const auto& object : system_->objects()) {
    if (object == nullptr || object->memory().arena() == nullptr) continue;
    holes_.push_back({HiddenAddress(object->memory().arena()), sizeof(Arena)});
    object->memory().arena()->ForEachBlock([&](char* block, size_t bytes,
                                               const Arena::Calls& calls) {
      nodes_.push_back(
          {.begin = HiddenAddress(block), .bytes = bytes, .object = object.get(), .calls = &calls});
    });
    // Adds the memory that NewRegion() (MCOOP.h) has given to the object to nodes_, the blocks and
    // regions that the search looks for.  This memory belongs to the object until DeleteRegion().
    // So it gets no owner in nodes_, and is never reported as a leak.
    for (void* const region : object->memory().private_regions())
      nodes_.push_back({.begin = HiddenAddress(region), .bytes = Arena::UsableSize(region)});
  }
}

void LeakSearch::CollectRegions() {
  const RegionTable& table = system_->regions();
  const auto [memory, bytes] = table.own_memory();
  holes_.push_back({HiddenAddress(memory), bytes});
  for (const auto& object : system_->objects()) {
    if (object == nullptr || !object->is_image() || object->memory().arena() == nullptr) continue;
    table.ForEachOf(object->id, [&](uint32_t id, char* base, size_t size) {
      // Skips a region in the host's heap, because ReadHost() searches that heap as a whole.
      if (!IsPlanned(base)) return;
      region_of_id_[id] = HiddenAddress(base);
      nodes_.push_back({.begin = HiddenAddress(base),
                        .bytes = size,
                        .object = object.get(),
                        .is_region = true,
                        .made_at = table.PlaceOf(id)});
    });
  }
}

void LeakSearch::CollectPool() {
  RCRegionPool::Visit(
      [this](const void* begin, size_t bytes) {
        holes_.push_back({HiddenAddress(begin), bytes});
      },
      [this](const RCRegion* region) {
        nodes_.push_back({.begin = HiddenAddress(region), .bytes = sizeof *region});
      });
}

void LeakSearch::Mark(size_t node) {
  if (std::exchange(nodes_[node].is_reachable, true)) return;
  reached_.push_back(node);
}

void LeakSearch::MarkAddress(uintptr_t address) {
  const auto after =
      std::upper_bound(nodes_.begin(), nodes_.end(), address,
                       [](uintptr_t a, const Node& node) { return a < node.begin.value(); });
  if (after == nodes_.begin()) return;
  const auto node = std::prev(after);
  if (address - node->begin.value() < std::max<size_t>(node->bytes, 1))
    Mark(static_cast<size_t>(node - nodes_.begin()));
}

void LeakSearch::MarkId(uint32_t id) {
  const auto found = region_of_id_.find(id);
  if (found != region_of_id_.end()) MarkAddress(found->second.value());
}

void LeakSearch::Read(const char* begin, const char* end, bool has_ids) {
  if (nodes_.empty()) return;
  const uintptr_t low = nodes_.front().begin.value();
  const uintptr_t high = nodes_.back().begin.value() + nodes_.back().bytes;
  const uintptr_t aligned = (reinterpret_cast<uintptr_t>(begin) + 7) / 8 * 8;
  const char* at = reinterpret_cast<const char*>(aligned);
  for (; at + sizeof(uint64_t) <= end; at += sizeof(uint64_t)) {
    uint64_t word;
    std::memcpy(&word, at, sizeof word);
    if (word == 0) continue;
    if (word >= low && word <= high) MarkAddress(word);
    if (!has_ids) continue;
    MarkId(static_cast<uint32_t>(word));
    MarkId(static_cast<uint32_t>(word >> 32));
  }
  // Reads the last 4 bytes if the size of the searched memory is no multiple of 8.  They may hold
  // the id of a region, which has 4 bytes.
  uint32_t rest;
  if (has_ids && end - at >= static_cast<ptrdiff_t>(sizeof rest)) {
    std::memcpy(&rest, at, sizeof rest);
    MarkId(rest);
  }
}

void LeakSearch::ReadReached() {
  while (!reached_.empty()) {
    const Node node = nodes_[reached_.back()];
    reached_.pop_back();
    Read(node.begin.pointer(), node.begin.pointer() + node.bytes, true);
  }
}

bool LeakSearch::HasWaitingHandler() const {
  const auto& objects = system_->objects();
  return std::any_of(objects.begin(), objects.end(), [](const auto& object) {
    return object != nullptr && object->running() != nullptr;
  });
}

// Searches the stacks of handlers for addresses of blocks and regions, but only if a handler waits.
// Otherwise the stacks hold only bytes that earlier handlers have left.
void LeakSearch::ReadStacks() {
  const bool has_waiting = HasWaitingHandler();
  for (const auto& [begin, bytes] : StackMemory::All()) {
    if (has_waiting) Read(begin, begin + bytes, true);
    if (!IsPlanned(begin)) holes_.push_back({HiddenAddress(begin), bytes});
  }
}

// Searches the memory from `begin` to `end`, except the parts in holes_ (memory that is not to be
// searched), for addresses of blocks and regions.
void LeakSearch::ReadAround(const char* begin, const char* end) {
  for (const Range& hole : holes_) {
    const char* const hole_end = hole.begin.pointer() + hole.bytes;
    if (hole_end <= begin) continue;
    if (hole.begin.pointer() >= end) break;
    if (hole.begin.pointer() > begin) Read(begin, hole.begin.pointer(), false);
    begin = std::min(hole_end, end);
  }
  if (begin < end) Read(begin, end, false);
}

bool IsOfImage(const System& system, const char* address) {
  const auto& objects = system.objects();
  return std::any_of(objects.begin(), objects.end(), [address](const auto& object) {
    if (object == nullptr || object->memory().addresses() == nullptr) return false;
    const char* const image = object->memory().addresses()->image();
    return image != nullptr && address >= image && address < image + ObjectAddresses::kImageBytes;
  });
}

// Returns all ranges of writable memory of this process.  They are collected before the search
// begins, because the list itself needs memory, and so changes the ranges while it grows.
std::vector<Range> WritableRanges(const char* stack) {
  std::vector<Range> writable;
  MemoryMap map;
  for (MappedRange range; map.Next(&range);) {
    if (!range.is_private_data) continue;
    // Leaves out the part of the stack below `stack`, because this search itself runs there and may
    // keep addresses of blocks.
    const uintptr_t begin = range.is_main_stack
                                ? std::max(range.begin, reinterpret_cast<uintptr_t>(stack))
                                : range.begin;
    writable.push_back({HiddenAddress(reinterpret_cast<const void*>(begin)), range.end - begin});
  }
  return writable;
}

// Searches all writable memory of this process for addresses of heap blocks and regions: the memory
// of the runtime and the variables of images.
void LeakSearch::ReadHost(const char* stack) {
  std::sort(holes_.begin(), holes_.end(),
            [](const Range& a, const Range& b) { return IsLess(a.begin, b.begin); });
  for (const Range& range : WritableRanges(stack)) {
    const char* const begin = range.begin.pointer();
    if (!IsPlanned(begin)) {
      ReadAround(begin, begin + range.bytes);
    } else if (IsOfImage(*system_, begin)) {
      Read(begin, begin + range.bytes, true);
    }
  }
}

void LeakSearch::Run(const char* stack) {
  CollectBlocks();
  CollectRegions();
  CollectPool();
  std::sort(nodes_.begin(), nodes_.end(),
            [](const Node& a, const Node& b) { return IsLess(a.begin, b.begin); });
  ReadStacks();
  ReadHost(stack);
  // Marks the memory that NewRegion() (MCOOP.h) has given to objects as reachable.  So a block
  // whose address is in this memory is no leak.
  for (const auto& object : system_->objects()) {
    if (object == nullptr || object->memory().arena() == nullptr) continue;
    for (void* const region : object->memory().private_regions())
      MarkAddress(reinterpret_cast<uintptr_t>(region));
  }
  ReadReached();
}

std::string PlaceOf(const Node& node) {
  std::string place = node.is_region ? NameOfPlace(node.made_at) : NameOfCalls(*node.calls);
  return place.empty() ? "at a place that has no debug information (openr build --debug)"
                       : "at " + place;
}

void LeakSearch::Report() const {
  struct Sum {
    size_t count = 0, bytes = 0;
  };
  std::map<std::tuple<ObjectId, bool, std::string>, Sum> sums;
  for (const Node& node : nodes_) {
    if (node.object == nullptr || node.is_reachable) continue;
    Sum& sum = sums[{node.object->id, node.is_region, PlaceOf(node)}];
    sum.count += 1;
    sum.bytes += node.bytes;
  }
  for (const auto& [key, sum] : sums) {
    const auto& [id, is_region, place] = key;
    const char* const what = is_region ? "region" : "block";
    system_->AddFindingAbout(
        system_->object(id), Severity::kNote,
        fmt::format("leak: {} {}{} of {} bytes, made {}: nothing points to {} any more", sum.count,
                    what, sum.count == 1 ? "" : "s", sum.bytes, place,
                    sum.count == 1 ? "it" : "them"));
  }
  if (sums.empty())
    system_->AddFindingAbout(nullptr, Severity::kNote, "no leaks of blocks or regions were found");
}

// Adds a note about each object whose heap is not known in this process, such as an object in a
// worker process, because its leaks cannot be found.
void ReportUnknown(System* system) {
  for (const auto& object : system->objects()) {
    if (object == nullptr || !object->is_image() || object->is_absent() ||
        object->memory().arena() != nullptr)
      continue;
    system->AddFindingAbout(object.get(), Severity::kNote,
                            "leaks were not looked for: its heap is in another process, or "
                            "belongs to AddressSanitizer");
  }
}

}  // namespace

[[gnu::noinline]] void ReportLeaks(System* system) {
  const auto* const stack = static_cast<const char*>(__builtin_frame_address(0));
  ReportUnknown(system);
  LeakSearch search(system);
  search.Run(stack);
  search.Report();
}

}  // namespace openr_host
