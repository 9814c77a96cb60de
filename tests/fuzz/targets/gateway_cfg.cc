// The fuzz target gateway_cfg: ROBOTGW.CFG and HOSTGW.CFG.
#include "runtime/config/gateway_config.h"
#include "runtime/config/line_file.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::gateway_cfg(std::string_view bytes) {
  bool has_proxy = false;
  for (const GatewaySide side : {GatewaySide::kRobot, GatewaySide::kHost}) {
    const GatewayConfig result = ParseGatewayConfig("ROBOTGW.CFG", bytes, kEveryDesign, side);
    Render(result.diagnostics);
    for (const GatewayRecord& record : result.services) FuzzCheck(record.port != 0, "a port");
    Render(CheckGatewayWires(ParseConnectConfig("CONNECT.CFG", bytes, kEveryDesign), result, "F"));
    has_proxy |= result.proxy && result.proxy->port == 54301;
  }
  return has_proxy;
}

}  // namespace openr_host
