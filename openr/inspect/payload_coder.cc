#include "openr/inspect/payload_coder.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "runtime/base/assert.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace openr_host {
namespace {

constexpr size_t kWord = 4;
constexpr size_t kWords = kPayloadBlock / kWord;
constexpr size_t kMaskBytes = kWords / 8;

// Compares two blocks of kPayloadBlock bytes.  Returns a bit for each word (4 bytes) of the blocks,
// which is 1 if the word differs.  The lowest bit is for the first word.
uint32_t ChangedWords(const char* now, const char* last) {
#if defined(__SSE2__)
  const auto equal = [now, last](size_t at) {
    return _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(now + at)),
                           _mm_loadu_si128(reinterpret_cast<const __m128i*>(last + at)));
  };
  // Each comparison gives 32 bits for a word: all 1 if the word is equal, else all 0.  The first
  // two steps shorten these bits to 16 and to 8, and the last step takes the highest bit.  So one
  // bit is left for each word.
  const __m128i first = _mm_packs_epi32(equal(0), equal(16));
  const __m128i second = _mm_packs_epi32(equal(32), equal(48));
  return static_cast<uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(first, second))) ^ 0xffffu;
#else
  uint32_t mask = 0;
  for (size_t i = 0; i < kWords; ++i)
    mask |= (std::memcmp(now + i * kWord, last + i * kWord, kWord) != 0 ? 1u : 0u) << i;
  return mask;
#endif
}

// Writes to `out` the bits of `mask`, and the words of `now` whose bits are set in `mask`.  Returns
// the end of the written bytes.
char* PutWords(uint32_t mask, const char* now, char* out) {
  *out++ = static_cast<char>(mask);
  *out++ = static_cast<char>(mask >> 8);
  for (; mask != 0; mask &= mask - 1, out += kWord)
    std::memcpy(out, now + static_cast<size_t>(std::countr_zero(mask)) * kWord, kWord);
  return out;
}

}  // namespace

void LastPayload::Write(std::string_view now, ByteWriter* out) {
  ASSERT(now.size() == size_);
  const size_t blocks = bytes_.size() / kPayloadBlock;
  // Makes room for the largest number of bytes that this function writes.  For each block, it
  // writes the number of unchanged blocks before it, a mask with a bit for each changed word, and
  // in the worst case all words of the block.
  char* at = out->Room(blocks * (kPayloadBlock + kMaskBytes + 1) + 2 * ByteWriter::kVarintBytesMax);
  size_t equal = 0;
  const auto compare = [&](const char* block, char* last) {
    const uint32_t mask = ChangedWords(block, last);
    if (mask == 0) {
      ++equal;
      return;
    }
    at = PutWords(mask, block, ByteWriter::PutVarint(equal, at));
    std::memcpy(last, block, kPayloadBlock);
    equal = 0;
  };
  const size_t whole = size_ / kPayloadBlock * kPayloadBlock;
  for (size_t i = 0; i < whole; i += kPayloadBlock) compare(now.data() + i, bytes_.data() + i);
  if (whole < size_) {
    // A copy of the last bytes of the payload `now`, filled up with zeros to a whole block, because
    // the comparison reads whole blocks and bytes behind `now` may not be read.
    char rest[kPayloadBlock] = {};
    std::memcpy(rest, now.data() + whole, size_ - whole);
    compare(rest, bytes_.data() + whole);
  }
  if (equal > 0) at = ByteWriter::PutVarint(equal, at);
  out->SetEnd(at);
}

void LastPayload::Read(ByteReader* in) {
  const size_t blocks = bytes_.size() / kPayloadBlock;
  const size_t words = (size_ + kWord - 1) / kWord;
  for (size_t block = 0; block < blocks; ++block) {
    const uint64_t equal = in->Varint();
    if (equal > blocks - block)
      throw std::runtime_error("more equal blocks of a message than it has");
    block += equal;
    if (block == blocks) return;
    uint32_t mask = in->U16();
    if (mask == 0) throw std::runtime_error("a changed block of a message without a changed word");
    for (; mask != 0; mask &= mask - 1) {
      const size_t word = block * kWords + static_cast<size_t>(std::countr_zero(mask));
      if (word >= words) throw std::runtime_error("a changed word behind the end of a message");
      std::memcpy(bytes_.data() + word * kWord, in->Bytes(kWord).data(), kWord);
    }
  }
}

void LastPayload::ReadPieces(ByteReader* in) {
  for (size_t at = 0; at < size_;) {
    const uint64_t equal = in->Varint();
    const std::string_view other = in->Text();
    if (equal > size_ - at || other.size() > size_ - at - equal || equal + other.size() == 0)
      throw std::runtime_error("pieces of a message are longer than it");
    bytes_.replace(at + equal, other.size(), other);
    at += equal + other.size();
  }
}

}  // namespace openr_host
