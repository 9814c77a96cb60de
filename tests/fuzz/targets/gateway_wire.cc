// The fuzz target gateway_wire: the bytes of TCPGateway, and OPEN-R calls in them.
#include "runtime/gateway/gateway_stream.h"
#include "runtime/gateway/proxy_wire.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::gateway_wire(std::string_view bytes) {
  bool has_call = false;
  FuzzBytes input(bytes);
  GatewayStream words, sets;
  bool is_broken = false;
  while (!input.empty() && !is_broken) {
    const std::string_view arrived = input.Text(size_t{1} + input.U8());
    words.Feed(arrived);
    sets.Feed(arrived);
    uint32_t word;
    while (words.NextWord(&word) == GatewayStream::Result::kTaken) {
    }
    GatewaySet set;
    GatewayStream::Result result;
    while ((result = sets.NextSet(&set)) == GatewayStream::Result::kTaken) {
      for (const std::string& item : set) {
        ProxyFrame frame;
        if (!DecodeProxyFrame(item, &frame).empty()) continue;
        FuzzCheck(frame.bytes.size() <= kProxyBytesMax, "the size of a call");
        has_call |= frame.command == ProxyCommand::kCall && frame.bytes.ends_with('!');
      }
    }
    is_broken = result == GatewayStream::Result::kBroken;
    FuzzCheck(is_broken != sets.error().empty(), "a broken stream has a reason");
  }
  return has_call;
}

}  // namespace openr_host
