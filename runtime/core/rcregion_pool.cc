#include "runtime/core/rcregion_pool.h"

#include <new>
#include <set>

#include "runtime/core/current.h"

namespace openr_host {
namespace {

// The number of RCRegions for which the pool takes memory from the host's heap at a time.
constexpr size_t kRegionsPerChunk = 64;

}  // namespace

thread_local constinit RCRegionPool::Block* RCRegionPool::t_free = nullptr;
thread_local constinit std::vector<RCRegionPool::Block*>* RCRegionPool::t_chunks = nullptr;

void RCRegionPool::AddChunk() {
  static_assert(offsetof(Block, region) == 0);
  const ApiScope scope;
  if (t_chunks == nullptr) t_chunks = new std::vector<Block*>;
  auto* const chunk = static_cast<Block*>(::operator new(sizeof(Block) * kRegionsPerChunk));
  t_chunks->push_back(chunk);
  for (size_t i = kRegionsPerChunk; i > 0; --i) Give(chunk + i - 1);
}

void RCRegionPool::Visit(const std::function<void(const void*, size_t)>& memory,
                         const std::function<void(const RCRegion*)>& used) {
  if (t_chunks == nullptr) return;
  std::set<const Block*> free;
  for (const Block* block = t_free; block != nullptr; block = block->next) free.insert(block);
  memory(t_chunks->data(), t_chunks->capacity() * sizeof(Block*));
  for (const Block* const chunk : *t_chunks) {
    memory(chunk, sizeof(Block) * kRegionsPerChunk);
    for (size_t i = 0; i < kRegionsPerChunk; ++i) {
      if (!free.contains(chunk + i)) used(reinterpret_cast<const RCRegion*>(chunk + i));
    }
  }
}

}  // namespace openr_host
