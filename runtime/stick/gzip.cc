#include "runtime/stick/gzip.h"

#include <zlib.h>

namespace openr_host {
namespace {

// The limit for the unpacked size of a gzip file, our choice and far above any file of a stick.
// The limit protects the host's memory, because even a small file may unpack to very many bytes.
constexpr size_t kBytesMax = 512u << 20;

}  // namespace

bool IsGzip(const std::string& bytes) {
  return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

GzipResult Gunzip(const std::string& packed, std::string* bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, 15 + 16) != Z_OK) return GzipResult::kDamaged;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int status = Z_OK;
  char buffer[1 << 16];
  while (status == Z_OK && bytes->size() < kBytesMax) {
    stream.next_out = reinterpret_cast<Bytef*>(buffer);
    stream.avail_out = sizeof buffer;
    status = inflate(&stream, Z_NO_FLUSH);
    bytes->append(buffer, sizeof buffer - stream.avail_out);
  }
  inflateEnd(&stream);
  if (status == Z_STREAM_END) return GzipResult::kWhole;
  return status == Z_BUF_ERROR ? GzipResult::kCutOff : GzipResult::kDamaged;
}

}  // namespace openr_host
