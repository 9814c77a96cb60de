#include "openr/remote/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

#include "openr/remote/connection.h"

namespace openr::remote {
namespace {

// Time between two requests that ask the robot whether the camera's picture is ready.
constexpr std::chrono::milliseconds kPictureWait{20};

// The payload of the request CAMERA_PART, which asks for one part of a picture.
struct PartNumber {
  int part;
  void Write(RcWriter* out) const { out->U16(static_cast<Uint32>(part)); }
};

// The payload of an answer to CAMERA_PART: one part of a picture.
struct PicturePart {
  RcPicturePart head;
  std::string bytes;
  bool Read(RcReader* in) {
    head.Read(in);
    bytes.assign(reinterpret_cast<const char*>(in->Rest()), static_cast<size_t>(in->RestSize()));
    return !in->HasFailed() && head.parts > 0;
  }
};

char Clipped(int value) { return static_cast<char>(std::clamp(value, 0, 255)); }

}  // namespace

Picture Connection::TakePicture(int layer) {
  Request(rcCAMERA, {static_cast<uint8_t>(layer)});
  return WaitForPicture();
}

Picture Connection::WaitForPicture() {
  const auto deadline = std::chrono::steady_clock::now() + options_.timeout;
  Answer first;
  while ((first = WaitForAny(Send(rcCAMERA_PART, BytesOf(PartNumber{0})))).status == rcerrorBUSY) {
    if (std::chrono::steady_clock::now() > deadline) {
      throw Error(
          first.status, first.frame,
          fmt::format("the camera has sent no picture within {} ms; the stick's CONNECT.CFG must "
                      "connect OVirtualRobotComm.FbkImageSensor with RCServer.Image",
                      options_.timeout.count()));
    }
    std::this_thread::sleep_for(kPictureWait);
  }
  if (first.status != rcOK) throw Error(first.status, first.frame, first.error);
  const auto part = Read<PicturePart>(first);
  Picture picture{part.head.frame, part.head.layer,  part.head.bands,
                  part.head.width, part.head.height, part.bytes};
  std::vector<Bytes> questions;
  for (int i = 1; i < part.head.parts; ++i) questions.push_back(BytesOf(PartNumber{i}));
  for (const Answer& answer : RequestAll(rcCAMERA_PART, questions)) {
    picture.bytes += Read<PicturePart>(answer).bytes;
  }
  return picture;
}

std::string Picture::Rgb() const {
  const auto row_size = static_cast<size_t>(width);
  if (bands < 3 || height < 1 || bytes.size() < row_size * static_cast<size_t>(height * bands)) {
    throw std::runtime_error("the picture is no layer that can be shown; --raw writes its bytes");
  }
  std::string pixels;
  for (int row = 0; row < height; ++row) {
    // Uses the row above for the last row of the band Y (brightness) of a camera picture, because
    // the last row begins with 16 bytes of other data.
    const int y_row = row == height - 1 && row > 0 ? row - 1 : row;
    const auto* const y = reinterpret_cast<const uint8_t*>(bytes.data()) +
                          row_size * static_cast<size_t>(y_row * bands);
    const auto* const cr = reinterpret_cast<const uint8_t*>(bytes.data()) +
                           row_size * static_cast<size_t>(row * bands + 1);
    const auto* const cb = cr + row_size;
    for (size_t x = 0; x < row_size; ++x) {
      // Subtracts 128, because the bytes are Cr = R - Y + 128 and Cb = B - Y + 128 (robot.md 11.2).
      const int red = cr[x] - 128;
      const int blue = cb[x] - 128;
      pixels += Clipped(y[x] + red);
      pixels += Clipped(y[x] - (131 * red + 49 * blue) / 256);
      pixels += Clipped(y[x] + blue);
    }
  }
  return pixels;
}

std::string Picture::File() const {
  if (bands != 1) return fmt::format("P6\n{} {}\n255\n", width, height) + Rgb();
  if (bytes.size() < static_cast<size_t>(width) * static_cast<size_t>(height)) {
    throw std::runtime_error("the picture is no layer that can be shown; --raw writes its bytes");
  }
  return fmt::format("P5\n{} {}\n255\n", width, height) + bytes;
}

}  // namespace openr::remote
