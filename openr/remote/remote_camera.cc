#include "openr/remote/remote_camera.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "openr/remote/remote_client.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr useconds_t kPictureWaitUs = 20'000;  // between two questions whether it is there

// The payload of CAMERA_PART.
struct PartNumber {
  int part;
  void Write(RcWriter* out) const { out->U16(static_cast<Uint32>(part)); }
};

// The payload of its answer.
struct PicturePart {
  RcPicturePart head;
  std::string bytes;
  bool Read(RcReader* in) {
    head.Read(in);
    bytes.assign(reinterpret_cast<const char*>(in->Rest()), static_cast<size_t>(in->RestSize()));
    return !in->HasFailed() && head.parts > 0;
  }
};

// Asks for the first part until the camera has sent the picture.
PicturePart WaitForPicture(RemoteClient* client, int timeout_ms) {
  const int64_t begin_ms = WallClockMs();
  for (;;) {
    try {
      return client->Read<PicturePart>(client->RequestWith(rcCAMERA_PART, PartNumber{0}));
    } catch (const RemoteRefusal& refusal) {
      if (refusal.status != rcerrorBUSY) throw;
    }
    if (WallClockMs() - begin_ms > timeout_ms) {
      throw std::runtime_error(fmt::format(
          "the camera has sent no picture within {} ms; the stick's CONNECT.CFG must connect "
          "OVirtualRobotComm.FbkImageSensor with RCServer.Image",
          timeout_ms));
    }
    usleep(kPictureWaitUs);
  }
}

uint8_t Clipped(int value) { return static_cast<uint8_t>(std::clamp(value, 0, 255)); }

}  // namespace

RemotePicture FetchPicture(RemoteClient* client, int layer, int timeout_ms) {
  client->UseVersion(RC_VERSION_FILES);
  client->Request(rcCAMERA, {static_cast<uint8_t>(layer)});
  PicturePart part = WaitForPicture(client, timeout_ms);
  RemotePicture picture{part.head.frame, part.head.layer,  part.head.bands,
                        part.head.width, part.head.height, part.bytes};
  for (int i = 1; i < part.head.parts; ++i) {
    part = client->Read<PicturePart>(client->RequestWith(rcCAMERA_PART, PartNumber{i}));
    picture.bytes += part.bytes;
  }
  return picture;
}

std::string RemotePicture::File() const {
  const auto row_size = static_cast<size_t>(width);
  const size_t size = row_size * static_cast<size_t>(height * bands);
  if (bytes.size() < size || (bands != 1 && bands < 3)) {
    throw std::runtime_error("the picture is no layer that can be shown; --raw writes its bytes");
  }
  if (bands == 1) return fmt::format("P5\n{} {}\n255\n", width, height) + bytes;
  std::string file = fmt::format("P6\n{} {}\n255\n", width, height);
  for (int row = 0; row < height; ++row) {
    // The last row of Y begins with 16 bytes of other data, so the row above stands for it.
    const int y_row = row == height - 1 && row > 0 ? row - 1 : row;
    const auto* const y = reinterpret_cast<const uint8_t*>(bytes.data()) +
                          row_size * static_cast<size_t>(y_row * bands);
    const auto* const cr = reinterpret_cast<const uint8_t*>(bytes.data()) +
                           row_size * static_cast<size_t>(row * bands + 1);
    const auto* const cb = cr + row_size;
    for (size_t x = 0; x < row_size; ++x) {
      const int red = cr[x] - 128;  // R - Y and B - Y (robot.md 11.2)
      const int blue = cb[x] - 128;
      file += static_cast<char>(Clipped(y[x] + red));
      file += static_cast<char>(Clipped(y[x] - (131 * red + 49 * blue) / 256));
      file += static_cast<char>(Clipped(y[x] + blue));
    }
  }
  return file;
}

}  // namespace openr_host
