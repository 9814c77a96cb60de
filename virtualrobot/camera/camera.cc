#include "virtualrobot/camera/camera.h"

#include <algorithm>
#include <bit>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {
namespace {

// The tables below have the factors by which the settings of the camera change the colours of a
// picture; kOne stands for the factor 1.  The index of each table is the parameter that an object
// passes to ControlPrimitive(), 1 to 3; element 0 is not used.  With the default settings, all
// factors are 1.  Gain and shutter make the image brighter or darker.  White balance multiplies red
// and divides blue by the square root of T / 4300 K, where T is the colour temperature of the
// setting.  The default setting has 4300 K.  The square root is our choice, because no measurement
// is known.
constexpr int kOne = 256;
constexpr int kGain[] = {0, kOne, kOne, 2 * kOne};         // 1 and 2: 0 dB, 3: 6 dB
constexpr int kShutter[] = {0, 2 * kOne, kOne, kOne / 2};  // 1: 1/50 s, 2: 1/100 s, 3: 1/200 s
constexpr int kRed[] = {0, 207, 327, kOne};  // factors of red; 1: 2800 K, 2: 7000 K, 3: 4300 K
constexpr int kBlue[] = {0, 317, 201, kOne};

// The colours that stand for the channels of the colour detection in a picture of layer C (the
// layer with the detected colours).  They also differ in lightness, so that people who see few
// colours can tell them apart.
constexpr std::array<std::array<uint8_t, 3>, ocdtNUM_CHANNELS> kChannelColours = {
    {{255, 140, 0},
     {90, 200, 255},
     {255, 80, 160},
     {255, 235, 60},
     {40, 160, 90},
     {70, 90, 220},
     {170, 60, 200},
     {240, 240, 240}}};

// Number of bytes before the data in an image vector: its header, and an OFbkImageInfo for each
// layer.
constexpr size_t kHeadBytes = sizeof(ODataVectorInfo) + ofbkimageNUM_LAYERS * sizeof(OFbkImageInfo);

bool Known(longword parameter) { return parameter >= 1 && parameter <= 3; }

// Returns the number of bytes of a picture of the camera's sensor.
size_t PictureBytes(const Camera& model) {
  return static_cast<size_t>(model.width_px) * static_cast<size_t>(model.height_px) * 3;
}

}  // namespace

CameraDevice::CameraDevice(std::unique_ptr<ImageSource> source, const Camera& model,
                           OPrimitiveID id)
    : source_(std::move(source)), model_(model), id_(id), layers_(model.width_px, model.height_px) {
  ASSERT(source_ != nullptr, "a camera without a source of pictures");
  picture_.width = model.width_px;
  picture_.height = model.height_px;
  ChooseExposure();
}

bool CameraDevice::SetWhiteBalance(longword mode) {
  if (!Known(mode)) return false;
  settings_.white_balance = mode;
  ChooseExposure();
  return true;
}

bool CameraDevice::SetGain(longword gain) {
  if (!Known(gain)) return false;
  settings_.gain = gain;
  ChooseExposure();
  return true;
}

bool CameraDevice::SetShutter(longword shutter) {
  if (!Known(shutter)) return false;
  settings_.shutter = shutter;
  ChooseExposure();
  return true;
}

void CameraDevice::set_auto_exposure(bool on) {
  settings_.auto_exposure = on;
  ChooseExposure();
}

void CameraDevice::set_auto_white_balance(bool on) {
  settings_.auto_white_balance = on;
  ChooseExposure();
}

// Computes exposure_, the tables that make the colours of a picture brighter or darker, from the
// settings.  When auto exposure or auto white balance is on, takes the default setting in place of
// the program's setting.
void CameraDevice::ChooseExposure() {
  const int light =
      settings_.auto_exposure ? kOne : kGain[settings_.gain] * kShutter[settings_.shutter] / kOne;
  const int red = settings_.auto_white_balance ? kOne : kRed[settings_.white_balance];
  const int blue = settings_.auto_white_balance ? kOne : kBlue[settings_.white_balance];
  const int factors[] = {light * red / kOne, light, light * blue / kOne};
  for (size_t colour = 0; colour < 3; ++colour) {
    for (int value = 0; value < 256; ++value) {
      exposure_[colour][static_cast<size_t>(value)] =
          static_cast<uint8_t>(std::min(value * factors[colour] / kOne, 255));
    }
  }
}

int64_t CameraDevice::ImagesBefore(int64_t frame) const {
  if (frame <= 0) return 0;
  // Adds a millionth before rounding down, because a product that should be a whole number may be a
  // little less.
  return static_cast<int64_t>(static_cast<double>(frame) * kFrame_s * model_.frames_per_s + 1e-6);
}

CameraShot CameraDevice::LastShot(int64_t frame, const Body& body) const {
  CameraShot shot;
  shot.number = earlier_images_ + ImagesBefore(frame);
  shot.frame = frame - 1;
  shot.fov_h_rad = model_.fov_h_rad;
  shot.fov_v_rad = model_.fov_v_rad;
  shot.body = &body;
  // Computes the axes of the lens in the frame L of the part that carries the lens.  The x axis is
  // the direction of view.  The y axis is horizontal in L, because the camera is not rolled.
  const Eigen::Vector3d& x = model_.direction;
  const Eigen::Vector3d y = Eigen::Vector3d::UnitZ().cross(x).normalized();
  Eigen::Isometry3d X_LC = Eigen::Isometry3d::Identity();
  X_LC.linear().col(0) = x;
  X_LC.linear().col(1) = y;
  X_LC.linear().col(2) = x.cross(y);
  X_LC.translation() = model_.place_m;
  shot.X_WC = body.PoseOf(static_cast<size_t>(model_.body)) * X_LC;
  return shot;
}

// Returns the number of bytes of the data of all layers of an image.
size_t CameraDevice::DataBytes() const {
  size_t bytes = 0;
  for (OFbkImageLayer layer = 0; layer < ofbkimageNUM_LAYERS; ++layer)
    bytes += layers_.BytesOf(layer);
  return bytes;
}

RCRegion* CameraDevice::FreeVector() {
  if (RCRegion* const free = pool_.FindFree()) return free;
  RCRegion* const region = NewVectorRegion(odataFBKIMAGE_VECTOR, sizeof(OFbkImageInfo),
                                           ofbkimageNUM_LAYERS, DataBytes());
  pool_.Add(region);
  return region;
}

// Fills in the OFbkImageInfo of each layer in `vector`.  This is repeated for every image, because
// an object that received the vector earlier may have overwritten them.
void CameraDevice::FillInfos(longword frame_number, OFbkImageVectorData* vector) const {
  size_t offset = kHeadBytes;
  for (OFbkImageLayer layer = 0; layer < ofbkimageNUM_LAYERS; ++layer) {
    OFbkImageInfo& info = *vector->GetInfo(static_cast<int>(layer));
    // Uses the data type for layers with six bands (luminance, two colours, three differences),
    // because recent system software always sends all six bands (BBS 1856).
    info.type = layer == ofbkimageLAYER_C ? odataFBK_CDT : odataFBK_YCrCb_HPF;
    info.primitiveID = id_;
    info.frameNumber = frame_number;
    info.dataOffset = static_cast<longword>(offset);
    info.dataSize = static_cast<longword>(layers_.BytesOf(layer));
    info.width = static_cast<longword>(layers_.WidthOf(layer));
    info.height = static_cast<longword>(layers_.HeightOf(layer));
    offset += layers_.BytesOf(layer);
  }
}

RCRegion* CameraDevice::MakeVector(int64_t frame, const Body& body, std::string* problem) {
  const CameraShot shot = LastShot(frame, body);
  // Allocates the memory of the picture here and not in the constructor, because most robots never
  // take an image.
  picture_.rgb.resize(PictureBytes(model_));
  *problem = source_->Capture(shot, &picture_);
  RCRegion* const region = FreeVector();
  auto* const vector = reinterpret_cast<OFbkImageVectorData*>(region->Base());
  FillInfos(FrameNumber(shot.frame), vector);
  layers_.Make(picture_, exposure_, tables_, static_cast<word>(ImagesBefore(frame) & 0xffff),
               vector);
  return region;
}

std::string CameraDevice::CopyPicture(int64_t frame, const Body& body, Picture* picture) {
  picture->width = model_.width_px;
  picture->height = model_.height_px;
  picture->rgb.resize(PictureBytes(model_));
  std::string problem = source_->Capture(LastShot(frame, body), picture);
  if (!problem.empty()) return problem;
  for (size_t i = 0; i < picture->rgb.size(); i += exposure_.size()) {
    for (size_t colour = 0; colour < exposure_.size(); ++colour)
      picture->rgb[i + colour] = exposure_[colour][picture->rgb[i + colour]];
  }
  return "";
}

std::string CameraDevice::CopyColours(int64_t frame, const Body& body, Picture* colours) {
  if (tables_.empty()) return "no object has set a colour table (OPENR::SetCdtVectorData)";
  Picture picture = picture_;
  picture.rgb.resize(PictureBytes(model_));
  std::string problem = source_->Capture(LastShot(frame, body), &picture);
  if (!problem.empty()) return problem;
  // Makes the vector in a local buffer and not in a region, because a region must belong to the
  // object that runs, and no object runs when somebody outside of the run asks for a picture.
  std::vector<byte> memory(kHeadBytes + DataBytes());
  auto* const vector = reinterpret_cast<OFbkImageVectorData*>(memory.data());
  FillInfos(0, vector);
  layers_.Make(picture, exposure_, tables_, 0, vector);
  const OFbkImageInfo& info = *vector->GetInfo(ofbkimageLAYER_C);
  const byte* const pixels = memory.data() + info.dataOffset;
  colours->width = static_cast<int>(info.width);
  colours->height = static_cast<int>(info.height);
  const auto count = static_cast<size_t>(colours->width) * static_cast<size_t>(colours->height);
  const size_t tag_begin = count - static_cast<size_t>(colours->width);
  colours->rgb.assign(count * 3, 0);
  for (size_t i = 0; i < count; ++i) {
    const bool is_tag = i >= tag_begin && i < tag_begin + ImageLayers::kTagBytes;
    if (is_tag || pixels[i] == 0) continue;
    const auto& colour = ColourOfChannel(std::countr_zero(pixels[i]));
    std::copy(colour.begin(), colour.end(), &colours->rgb[i * 3]);
  }
  return "";
}

const std::array<uint8_t, 3>& CameraDevice::ColourOfChannel(int channel) {
  return kChannelColours.at(static_cast<size_t>(channel));
}

void CameraDevice::SwitchOff(int64_t frame) {
  // Adds the number of images of this boot to the number of earlier images, because frames count
  // from 0 again after the next boot, but the source of pictures goes on with its next picture.
  earlier_images_ += ImagesBefore(frame);
  settings_ = {};
  tables_ = {};
  ChooseExposure();
  pool_.Clear();
}

void CameraDevice::HashState(Hasher* hasher) const {
  hasher->Add(settings_.white_balance);
  hasher->Add(settings_.gain);
  hasher->Add(settings_.shutter);
  hasher->Add(settings_.auto_exposure);
  hasher->Add(settings_.auto_white_balance);
  tables_.HashState(hasher);
}

}  // namespace openr_host
