#include "openr/remote/remote_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "Crc32.h"
#include "openr/remote/remote_client.h"

namespace openr_host {
namespace {

// Number of parts of a file that are sent before the first answer is awaited.  The answers of so
// many fit into the buffers of the network, so neither side blocks the other.
constexpr size_t kPartsInFlight = 32;

std::vector<uint8_t> UploadPart(const std::string& bytes, size_t offset) {
  std::vector<uint8_t> part(RC_MAX_PACKET);
  RcWriter writer(part.data(), RC_MAX_PACKET);
  writer.U32(static_cast<Uint32>(offset));
  const size_t count = std::min<size_t>(RC_MAX_UPLOAD_DATA, bytes.size() - offset);
  writer.Bytes(reinterpret_cast<const Uint8*>(bytes.data()) + offset, static_cast<int>(count));
  part.resize(static_cast<size_t>(writer.Size()));
  return part;
}

// The payload of MTN_LIST.
struct FirstIndex {
  size_t first;
  void Write(RcWriter* out) const { out->U16(static_cast<Uint32>(first)); }
};

}  // namespace

RcInfo AskFileInfo(RemoteClient* client) {
  client->UseVersion(RC_VERSION_FILES);
  return client->Read<RcInfo>(client->Request(rcINFO));
}

std::vector<RcListEntry> ListMotions(RemoteClient* client, uint32_t* frame) {
  client->UseVersion(RC_VERSION_FILES);
  std::vector<RcListEntry> all;
  for (;;) {
    const RemoteAnswer answer = client->RequestWith(rcMTN_LIST, FirstIndex{all.size()});
    const RcList part = client->Read<RcList>(answer);
    *frame = answer.frame;
    all.insert(all.end(), part.entries.begin(), part.entries.end());
    if (part.entries.empty() || all.size() >= part.total) return all;
  }
}

uint32_t UploadFile(RemoteClient* client, RcFileKind kind, const std::string& name,
                    const std::string& bytes, const std::function<void(size_t done)>& progress) {
  client->UseVersion(RC_VERSION_FILES);
  const Uint32 crc =
      Crc32(0, reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(bytes.size()));
  client->RequestWith(rcUPLOAD_BEGIN, RcUploadBegin{static_cast<Uint8>(kind), name,
                                                    static_cast<Uint32>(bytes.size()), crc});
  for (size_t at = 0; at < bytes.size();) {
    std::vector<std::vector<uint8_t>> parts;
    for (; at < bytes.size() && parts.size() < kPartsInFlight; at += RC_MAX_UPLOAD_DATA) {
      parts.push_back(UploadPart(bytes, at));
    }
    client->RequestAll(rcUPLOAD_DATA, parts);
    progress(std::min(at, bytes.size()));
  }
  return client->Request(rcUPLOAD_END).frame;
}

std::string DownloadFile(RemoteClient* client, RcFileKind kind, const std::string& name,
                         uint32_t* frame) {
  client->UseVersion(RC_VERSION_FILES);
  std::string bytes;
  size_t size = 0;
  do {
    const RcDownload request{static_cast<Uint8>(kind), name, static_cast<Uint32>(bytes.size())};
    const RemoteAnswer answer = client->RequestWith(rcDOWNLOAD, request);
    RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
    const size_t size_now = reader.U32();
    const bool ends_early = reader.RestSize() == 0 && bytes.size() < size_now;
    if (ends_early || (!bytes.empty() && size_now != size)) {
      throw std::runtime_error(
          fmt::format("{}: the file on the stick changed during the download; try again", name));
    }
    size = size_now;
    bytes.append(reinterpret_cast<const char*>(reader.Rest()),
                 static_cast<size_t>(reader.RestSize()));
    *frame = answer.frame;
  } while (bytes.size() < size);
  return bytes;
}

}  // namespace openr_host
