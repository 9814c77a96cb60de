// The FbkImageSensor service and the colour tables: robot.md 11, field-notes.md 9.
#include <OPENR/OFbkImage.h>
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class Viewer : public CodeObject {
 public:
  Viewer() {
    image = AddObserver("Viewer.Image.OFbkImageVectorData.O", [this](const ONotifyEvent& event) {
      times.push_back(system().now_us());
      region = event.RCData(0);
      vector = reinterpret_cast<OFbkImageVectorData*>(region->Base());
      frames.push_back(vector->GetInfo(0)->frameNumber);
      counters.push_back(Band(ofbkimageLAYER_H, ofbkimageBAND_Y).FieldCounter());
      if (on_image) on_image();
      if (assert_ready) image->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    image->AssertReady();
    return oSUCCESS;
  }
  OFbkImage Band(OFbkImageLayer layer, OFbkImageBand band) const {
    return OFbkImage(vector->GetInfo(static_cast<int>(layer)),
                     vector->GetData(static_cast<int>(layer)), band);
  }

  OObserver* image;
  RCRegion* region = nullptr;
  OFbkImageVectorData* vector = nullptr;
  std::vector<int64_t> times;
  std::vector<longword> frames;
  std::vector<int> counters;
  bool assert_ready = true;
  std::function<void()> on_image;
};

// Keeps the shots that it was asked for.
class ShotRecorder : public ImageSource {
 public:
  std::string Capture(const CameraShot& shot, Picture* picture) override {
    shots.push_back(shot);
    std::fill(picture->rgb.begin(), picture->rgb.end(), grey);
    if (paint) paint(picture);
    return problem;
  }
  std::vector<CameraShot> shots;
  uint8_t grey = 100;
  std::function<void(Picture*)> paint;
  std::string problem;
};

class ImageTest : public VirtualRobotCommTest {
 protected:
  explicit ImageTest(const char* name = "ers210", bool viewed = true)
      : ImageTest(Wire(), name, viewed) {}

  // All segments of one channel.
  static void FillTable(OCdtInfo* info, OPrimitiveID camera, OCdtChannel channel, byte cr_max,
                        byte cr_min, byte cb_max, byte cb_min) {
    info->Init(camera, channel);
    for (int segment = 0; segment < 32; ++segment)
      info->Set(segment, cr_max, cr_min, cb_max, cb_min);
  }
  Viewer* viewer = nullptr;
  ShotRecorder* source = nullptr;

 private:
  struct Wired {
    ShotRecorder* source;
    VirtualRobotOptions options;
  };
  ImageTest(Wired wired, const char* name, bool viewed)
      : VirtualRobotCommTest(std::move(wired.options), name), source(wired.source) {
    viewer = system.AddObject<Viewer>(dog, "viewer");
    if (!viewed) return;
    system.Connect({dog, "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
                    "Viewer.Image.OFbkImageVectorData.O", "test"});
  }
  static Wired Wire() {
    auto recorder = std::make_unique<ShotRecorder>();
    ShotRecorder* const seen = recorder.get();
    return {seen, {nullptr, nullptr, std::move(recorder), {}}};
  }
};

TEST_F(ImageTest, AnImageComesEvery40MillisecondsWithTheFrameItBelongsTo) {
  Boot();
  RunToFrame(16);
  EXPECT_EQ(viewer->times, (std::vector<int64_t>{80000, 120000}));
  EXPECT_EQ(viewer->frames, (std::vector<longword>{4, 9}));
  EXPECT_EQ(viewer->counters, (std::vector<int>{1, 2}));
}

// Notes the frames of the two newest sensor vectors when an image comes.
TEST_F(ImageTest, TheSensorsOfAnImageAreAmongTheTwoNewestVectors) {
  std::vector<int64_t> distances;
  viewer->on_image = [&] {
    const int64_t complete = (system.now_us() / 8000) / 4 * 4 - 1;  // the last frame of the newest
    distances.push_back(complete - int64_t{viewer->frames.back()});
  };
  Boot();
  RunToFrame(200);
  ASSERT_GT(distances.size(), 30u);
  for (const int64_t distance : distances) {
    EXPECT_GE(distance, 0);
    EXPECT_LE(distance, 7);
  }
}

TEST_F(ImageTest, TheVectorHasTheRobotsLayout) {
  Boot();
  RunToFrame(10);
  const ODataVectorInfo& header = viewer->vector->vectorInfo;
  EXPECT_EQ(header.type, odataFBKIMAGE_VECTOR);
  EXPECT_EQ(header.infoSize, 32u);
  EXPECT_EQ(header.numData, 4u);
  EXPECT_EQ(header.totalSize, viewer->region->Size());
  const longword sizes[][2] = {{176, 144}, {88, 72}, {44, 36}, {88, 72}};
  OPrimitiveID camera = 0;
  As([&] { camera = mover->Open(kCamera); });
  for (int layer = 0; layer < 4; ++layer) {
    const OFbkImageInfo& info = *viewer->vector->GetInfo(layer);
    EXPECT_EQ(info.width, sizes[layer][0]);
    EXPECT_EQ(info.height, sizes[layer][1]);
    EXPECT_EQ(info.type, layer == 3 ? odataFBK_CDT : odataFBK_YCrCb_HPF);
    EXPECT_EQ(info.dataSize, info.width * info.height * (layer == 3 ? 1 : 6));
    EXPECT_EQ(info.primitiveID, camera);
    EXPECT_LE(info.dataOffset + info.dataSize, header.totalSize);
  }
}

class Ers7ImageTest : public ImageTest {
 protected:
  Ers7ImageTest() : ImageTest("ers7") {}
};

TEST_F(Ers7ImageTest, TheErs7SendsThirtyLargerImagesASecond) {
  Boot();
  RunToFrame(130);  // the first one has come after two periods
  EXPECT_EQ(viewer->frames.size(), 30u);
  EXPECT_EQ(viewer->vector->GetInfo(0)->width, 208u);
  EXPECT_EQ(viewer->vector->GetInfo(2)->height, 40u);
}

class UnseenImageTest : public ImageTest {
 protected:
  UnseenImageTest() : ImageTest("ers210", false) {}
};

TEST_F(UnseenImageTest, WithoutAnObserverNoPictureIsTaken) {
  Boot();
  RunToFrame(50);
  EXPECT_TRUE(source->shots.empty());
}

TEST_F(ImageTest, NorForOneThatDeassertedItsReady) {
  Boot();
  RunAs(viewer, [&] { viewer->image->DeassertReady(); });
  RunToFrame(50);
  EXPECT_TRUE(source->shots.empty());
  RunAs(viewer, [&] { viewer->image->AssertReady(); });
  RunToFrame(60);
  EXPECT_EQ(viewer->counters, std::vector<int>{11});  // images are counted all the time
}

TEST_F(ImageTest, ASlowObserverLosesImagesAndThenGetsTheNewest) {
  viewer->assert_ready = false;
  Boot();
  RunToFrame(52);
  EXPECT_EQ(viewer->counters, std::vector<int>{1});
  RunAs(viewer, [&] { viewer->image->AssertReady(); });
  system.RunFor(1);
  EXPECT_EQ(viewer->counters, (std::vector<int>{1, 9}));
}

TEST_F(ImageTest, AnImageUnderReferenceIsNeverOverwritten) {
  RCRegion* kept = nullptr;
  viewer->on_image = [&] {
    if (kept != nullptr) return;
    kept = viewer->region;
    kept->AddReference();
  };
  Boot();
  RunToFrame(10);
  const std::vector<char> before(kept->Base(), kept->Base() + kept->Size());
  source->grey = 7;
  RunToFrame(60);
  EXPECT_EQ(std::memcmp(before.data(), kept->Base(), before.size()), 0);
  EXPECT_EQ(viewer->Band(ofbkimageLAYER_L, ofbkimageBAND_Y).Pixel(0, 0), 7);
}

TEST_F(ImageTest, TheSourceLearnsWhenAndFromWhereThePictureIsTaken) {
  Boot();
  RunToFrame(10);
  ASSERT_EQ(source->shots.size(), 2u);
  EXPECT_EQ(source->shots[1].number, 2);
  EXPECT_EQ(source->shots[1].frame, 9);
  // The body of these tests keeps all parts where they are at zero angles.
  EXPECT_TRUE(source->shots[1].X_WC.translation().isApprox(model.camera.place_m));
  EXPECT_TRUE(source->shots[1].X_WC.linear().isApprox(Eigen::Matrix3d::Identity()));
  EXPECT_DOUBLE_EQ(source->shots[1].fov_h_rad, model.camera.fov_h_rad);
}

TEST_F(ImageTest, ASourceWithoutAPictureIsReportedAndTheStreamGoesOn) {
  source->problem = "a.png: cannot be read";
  Boot();
  RunToFrame(12);
  EXPECT_EQ(CountFindings("camera: a.png: cannot be read"), 1);
  EXPECT_EQ(viewer->counters.size(), 1u);
}

TEST_F(ImageTest, SomebodyOutsideSeesTheSameWithItsSettings) {
  Boot();
  RunToFrame(10);
  EXPECT_TRUE(robot->HasNewImage());
  As([&] {
    OPrimitiveControl_CameraParam gain(ocamparamGAIN_HIGH);
    OPENR::ControlPrimitive(mover->Open(kCamera), oprmreqCAM_SET_GAIN, &gain, sizeof gain, nullptr,
                            0);
  });
  const uint64_t before = system.state_hash();
  Picture picture;
  EXPECT_EQ(robot->CopyPicture(&picture), "");
  EXPECT_EQ(picture.width, 352);
  EXPECT_EQ(picture.height, 288);
  EXPECT_EQ(picture.rgb.size(), 3u * 352 * 288);
  EXPECT_EQ(picture.rgb.front(), 200);
  EXPECT_EQ(picture.rgb.back(), 200);
  EXPECT_EQ(source->shots.back().number, 2);
  EXPECT_EQ(source->shots.back().frame, 9);
  EXPECT_EQ(system.state_hash(), before);
  RunToFrame(11);
  EXPECT_FALSE(robot->HasNewImage());
  source->problem = "a.png: cannot be read";
  EXPECT_EQ(robot->CopyPicture(&picture), "a.png: cannot be read");
  EXPECT_EQ(robot->CopyColours(&picture),
            "no object has set a colour table (OPENR::SetCdtVectorData)");
}

// Colours and sides are those of the vector that objects get of the same image.
TEST_F(ImageTest, SomebodyOutsideSeesWhatObjectsSee) {
  source->paint = [](Picture* picture) {
    for (int y = 0; y < picture->height; ++y) {
      for (int x = 0; x < picture->width; ++x) {
        uint8_t* const rgb = picture->At(x, y);
        rgb[0] = static_cast<uint8_t>(60 + x / 4);
        rgb[1] = static_cast<uint8_t>(60 + y / 4);
        rgb[2] = static_cast<uint8_t>(140 - x / 8 - y / 8);
      }
    }
  };
  Boot();
  RunToFrame(10);
  Picture picture;
  EXPECT_EQ(robot->CopyPicture(&picture), "");
  OFbkImage luminance = viewer->Band(ofbkimageLAYER_H, ofbkimageBAND_Y);
  OFbkImage red = viewer->Band(ofbkimageLAYER_H, ofbkimageBAND_Cr);
  OFbkImage blue = viewer->Band(ofbkimageLAYER_H, ofbkimageBAND_Cb);
  for (const int y : {10, 72, 130}) {
    for (const int x : {10, 88, 165}) {
      SCOPED_TRACE(fmt::format("{} {}", x, y));
      const uint8_t* const seen = picture.At(2 * x, 2 * y);
      EXPECT_NEAR(luminance.Pixel(x, y) + red.Pixel(x, y) - 128, seen[0], 3);
      EXPECT_NEAR(luminance.Pixel(x, y) + blue.Pixel(x, y) - 128, seen[2], 3);
      EXPECT_NEAR(luminance.Pixel(x, y), 0.299 * seen[0] + 0.587 * seen[1] + 0.114 * seen[2], 4);
    }
  }
}

// ---- settings

TEST_F(ImageTest, GainShutterAndAutomaticExposureChangeTheLight) {
  Boot();
  As([&] {
    const OPrimitiveID camera = mover->Open(kCamera);
    const auto light = [&](OPrimitiveRequest request, longword value) {
      OPrimitiveControl_CameraParam param(value);
      EXPECT_EQ(OPENR::ControlPrimitive(camera, request, &param, sizeof param, nullptr, 0),
                oSUCCESS);
      RunToFrame(robot->frame() + 10);
      return int{viewer->Band(ofbkimageLAYER_M, ofbkimageBAND_Y).Pixel(0, 0)};
    };
    EXPECT_EQ(light(oprmreqCAM_SET_GAIN, ocamparamGAIN_LOW), 100);
    EXPECT_EQ(light(oprmreqCAM_SET_GAIN, ocamparamGAIN_HIGH), 200);
    EXPECT_EQ(light(oprmreqCAM_SET_SHUTTER_SPEED, ocamparamSHUTTER_FAST), 100);
    EXPECT_EQ(light(oprmreqCAM_SET_SHUTTER_SPEED, ocamparamSHUTTER_SLOW), 255);
    EXPECT_EQ(OPENR::ControlPrimitive(camera, oprmreqCAM_AE_ON, nullptr, 0, nullptr, 0), oSUCCESS);
    EXPECT_EQ(light(oprmreqCAM_SET_GAIN, ocamparamGAIN_HIGH), 100);
  });
}

TEST_F(ImageTest, WhiteBalanceMovesRedAgainstBlue) {
  Boot();
  As([&] {
    const OPrimitiveID camera = mover->Open(kCamera);
    const auto colour = [&](longword mode) {
      OPrimitiveControl_CameraParam param(mode);
      OPENR::ControlPrimitive(camera, oprmreqCAM_SET_WHITE_BALANCE, &param, sizeof param, nullptr,
                              0);
      RunToFrame(robot->frame() + 10);
      return viewer->Band(ofbkimageLAYER_M, ofbkimageBAND_Cr).Pixel(0, 0) -
             viewer->Band(ofbkimageLAYER_M, ofbkimageBAND_Cb).Pixel(0, 0);
    };
    EXPECT_EQ(colour(ocamparamWB_FL_MODE), 0);
    EXPECT_LT(colour(ocamparamWB_INDOOR_MODE), -20);
    EXPECT_GT(colour(ocamparamWB_OUTDOOR_MODE), 20);
  });
}

// ---- colour tables

TEST_F(ImageTest, AColourTableFillsLayerCAndTheFrequencies) {
  Boot();
  As([&] {
    MemoryRegionID id = 0;
    OCdtVectorData* cdt = nullptr;
    EXPECT_EQ(OPENR::NewCdtVectorData(&id, &cdt), oSUCCESS);
    EXPECT_EQ(cdt->vectorInfo.type, odataCDT_VECTOR);
    EXPECT_EQ(cdt->vectorInfo.maxNumData, 8u);
    EXPECT_EQ(cdt->vectorInfo.numData, 0u);
    cdt->SetNumData(1);
    FillTable(cdt->GetInfo(0), mover->Open(kCamera), ocdtCHANNEL6, 130, 126, 130, 126);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oSUCCESS);
    EXPECT_EQ(OPENR::DeleteCdtVectorData(id), oSUCCESS);  // the camera has its own copy
    EXPECT_EQ(OPENR::DeleteCdtVectorData(id), oFAIL);
  });
  RunToFrame(10);
  EXPECT_EQ(viewer->Band(ofbkimageLAYER_C, ofbkimageBAND_CDT).Pixel(87, 71), ocdtCHANNEL6);
  OFbkImage y = viewer->Band(ofbkimageLAYER_H, ofbkimageBAND_Y);
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL6), 255);  // 6336 / 16 does not fit into a byte
  EXPECT_EQ(y.ColorFrequency(ocdtCHANNEL0), 0);
}

// The test pattern: its ball is found in layer C, in the way of BallTrackingHead.
class PatternTest : public VirtualRobotCommTest {
 protected:
  PatternTest() : VirtualRobotCommTest({nullptr, nullptr, std::make_unique<TestPattern>(), {}}) {}
};

TEST_F(PatternTest, ThePinkBallOfTheTestPatternIsFoundByColour) {
  Viewer* const viewer = system.AddObject<Viewer>(dog, "viewer");
  system.Connect({dog, "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
                  "Viewer.Image.OFbkImageVectorData.O", "test"});
  Boot();
  As([&] {
    MemoryRegionID id = 0;
    OCdtVectorData* cdt = nullptr;
    OPENR::NewCdtVectorData(&id, &cdt);
    cdt->SetNumData(1);
    cdt->GetInfo(0)->Init(mover->Open(kCamera), ocdtCHANNEL0);
    for (int segment = 0; segment < 32; ++segment)
      cdt->GetInfo(0)->Set(segment, 230, 190, 160, 120);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oSUCCESS);
  });
  std::vector<int> places;
  viewer->on_image = [&] {
    OFbkImage detected = viewer->Band(ofbkimageLAYER_C, ofbkimageBAND_CDT);
    int count = 0, sum = 0;
    for (int y = 0; y < detected.Height() - 1; ++y) {  // not the row with the tag
      for (int x = 0; x < detected.Width(); ++x) {
        if ((detected.Pixel(x, y) & ocdtCHANNEL0) == 0) continue;
        ++count;
        sum += x;
      }
    }
    EXPECT_NEAR(count, 250, 40);
    EXPECT_EQ(detected.ColorFrequency(ocdtCHANNEL0), count / 16);
    places.push_back(sum / std::max(count, 1));
  };
  RunToFrame(125);
  Picture colours;
  EXPECT_EQ(robot->CopyColours(&colours), "");
  RunToFrame(130);
  ASSERT_EQ(places.size(), 25u);
  EXPECT_LT(places.front(), 15);
  EXPECT_GT(places.back(), 40);

  // Somebody outside has seen the pixels of the image that objects get five frames later.
  OFbkImage detected = viewer->Band(ofbkimageLAYER_C, ofbkimageBAND_CDT);
  ASSERT_EQ(colours.width, detected.Width());
  ASSERT_EQ(colours.height, detected.Height());
  const auto& pink = CameraDevice::ColourOfChannel(0);
  for (int y = 0; y < detected.Height(); ++y) {
    for (int x = y < detected.Height() - 1 ? 0 : ImageLayers::kTagBytes; x < detected.Width();
         ++x) {
      const bool is_ball = (detected.Pixel(x, y) & ocdtCHANNEL0) != 0;
      const uint8_t* const rgb = colours.At(x, y);
      ASSERT_EQ(rgb[0] == pink[0] && rgb[1] == pink[1] && rgb[2] == pink[2], is_ball)
          << x << " " << y;
    }
  }
}

TEST_F(ImageTest, SetCdtVectorDataSaysWhatIsWrong) {
  Boot();
  As([&] {
    MemoryRegionID id = 0;
    OCdtVectorData* cdt = nullptr;
    OPENR::NewCdtVectorData(&id, &cdt);
    const OPrimitiveID camera = mover->Open(kCamera);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oSUCCESS);  // no table: nothing to do
    cdt->SetNumData(2);
    FillTable(cdt->GetInfo(0), camera, ocdtCHANNEL0, 130, 126, 130, 126);
    FillTable(cdt->GetInfo(1), camera, ocdtCHANNEL0 | ocdtCHANNEL1, 130, 126, 130, 126);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oINVALID_ARG);
    FillTable(cdt->GetInfo(1), mover->Open(kPan), ocdtCHANNEL1, 130, 126, 130, 126);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oINVALID_PRIMITIVE_ID);
    cdt->SetNumData(9);
    EXPECT_EQ(OPENR::SetCdtVectorData(id), oINVALID_ARG);
    EXPECT_EQ(OPENR::SetCdtVectorData(12345), oFAIL);
    MemoryRegionID command = 0;
    OCommandVectorData* data = nullptr;
    OPENR::NewCommandVectorData(20, &command, &data);
    EXPECT_EQ(OPENR::SetCdtVectorData(command), oINVALID_DATA_TYPE);
  });
  RunToFrame(10);
  EXPECT_EQ(viewer->Band(ofbkimageLAYER_C, ofbkimageBAND_CDT).Pixel(3, 3), 0);
}

TEST_F(ImageTest, TheStateHashSeesSettingsAndTables) {
  Boot();
  const uint64_t before = system.state_hash();
  As([&] {
    OPENR::ControlPrimitive(mover->Open(kCamera), oprmreqCAM_AE_ON, nullptr, 0, nullptr, 0);
  });
  EXPECT_NE(system.state_hash(), before);
}

TEST_F(ImageTest, TwoRunsSendTheSameImages) {
  Boot();
  RunToFrame(20);
  const uint64_t first = system.trace_hash();
  ImageTest_TwoRunsSendTheSameImages_Test other;
  other.Boot();
  other.RunToFrame(20);
  EXPECT_EQ(other.system.trace_hash(), first);
}

}  // namespace
}  // namespace openr_host
