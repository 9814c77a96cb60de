// The part of Connection for files of the robot's Memory Stick.
#include <fmt/format.h>

#include <algorithm>

#include "Crc32.h"
#include "openr/remote/connection.h"

namespace openr::remote {
namespace {

Bytes UploadPart(const std::string& bytes, size_t offset) {
  Bytes part(RC_MAX_PACKET);
  RcWriter writer(part.data(), RC_MAX_PACKET);
  writer.U32(static_cast<Uint32>(offset));
  const size_t count = std::min<size_t>(RC_MAX_UPLOAD_DATA, bytes.size() - offset);
  writer.Bytes(reinterpret_cast<const Uint8*>(bytes.data()) + offset, static_cast<int>(count));
  part.resize(static_cast<size_t>(writer.Size()));
  return part;
}

// The payload of the request MTN_LIST, which asks for a list of motion files.
struct FirstIndex {
  size_t first;
  void Write(RcWriter* out) const { out->U16(static_cast<Uint32>(first)); }
};

}  // namespace

std::vector<ListEntry> Connection::ListMotions() {
  std::vector<ListEntry> all;
  for (;;) {
    const RcList part = Read<RcList>(Request(rcMTN_LIST, BytesOf(FirstIndex{all.size()})));
    all.insert(all.end(), part.entries.begin(), part.entries.end());
    if (part.entries.empty() || all.size() >= part.total) return all;
  }
}

void Connection::Upload(RcFileKind kind, const std::string& name, const std::string& bytes,
                        const Progress& progress) {
  const Uint32 crc =
      Crc32(0, reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(bytes.size()));
  Request(rcUPLOAD_BEGIN, BytesOf(RcUploadBegin{static_cast<Uint8>(kind), name,
                                                static_cast<Uint32>(bytes.size()), crc}));
  if (progress) progress(0, bytes.size());
  for (size_t at = 0; at < bytes.size();) {
    std::vector<Bytes> parts;
    for (; at < bytes.size() && parts.size() < kInFlight; at += RC_MAX_UPLOAD_DATA) {
      parts.push_back(UploadPart(bytes, at));
    }
    RequestAll(rcUPLOAD_DATA, parts);
    if (progress) progress(std::min(at, bytes.size()), bytes.size());
  }
  Request(rcUPLOAD_END);
}

std::string Connection::Download(RcFileKind kind, const std::string& name,
                                 const Progress& progress) {
  std::string bytes;
  size_t size = 0;
  do {
    const RcDownload request{static_cast<Uint8>(kind), name, static_cast<Uint32>(bytes.size())};
    const Answer answer = Request(rcDOWNLOAD, BytesOf(request));
    RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
    const size_t size_now = reader.U32();
    if (reader.HasFailed() || size_now > RC_MAX_IMAGE) ThrowMalformed();
    const bool ends_early = reader.RestSize() == 0 && bytes.size() < size_now;
    if (ends_early || (!bytes.empty() && size_now != size)) {
      throw Error(ErrorCode::kFileChanged,
                  name + ": the file on the stick changed during the download", "try again");
    }
    size = size_now;
    if (bytes.empty() && progress) progress(0, size);
    bytes.append(reinterpret_cast<const char*>(reader.Rest()),
                 static_cast<size_t>(reader.RestSize()));
    if (progress) progress(bytes.size(), size);
  } while (bytes.size() < size);
  return bytes;
}

void Connection::DeleteMotion(const std::string& name) {
  Request(rcDELETE, BytesOf(RcFileName{rcfileMOTION, name}));
}

}  // namespace openr::remote
