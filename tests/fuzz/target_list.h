// The names of all fuzz targets.  Each is a function in a file of its name in tests/fuzz/targets.
#pragma once

#include <string_view>

// clang-format off
#define OPENR_FUZZ_TARGETS(F)                                                                      \
  F(aibo_log) F(camera_picture) F(connect_cfg) F(cost) F(csv_table) F(dds_forged)                  \
  F(dds_message) F(designdb_cfg) F(emon_log) F(event_script) F(gateway) F(gateway_cfg)             \
  F(gateway_wire) F(hostaddr_cfg) F(image) F(ipstack) F(joint_command) F(live_request)             \
  F(mcap_table) F(motion_csv) F(mtn) F(object_cfg) F(ocf) F(oda) F(panel) F(panel_http)            \
  F(panel_websocket) F(placement) F(properties) F(recording) F(remote_answer) F(remote_control)    \
  F(robot_code) F(robot_model) F(schedule) F(serve) F(stub_cfg) F(wav) F(wlanconf) F(world)
// clang-format on

namespace openr_host::fuzz {

#define OPENR_FUZZ_DECLARE(name) bool name(std::string_view bytes);
OPENR_FUZZ_TARGETS(OPENR_FUZZ_DECLARE)
#undef OPENR_FUZZ_DECLARE

}  // namespace openr_host::fuzz
