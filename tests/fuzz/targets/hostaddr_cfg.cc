// The fuzz target hostaddr_cfg: HOSTADDR.CFG.
#include "runtime/config/address_config.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::hostaddr_cfg(std::string_view bytes) {
  const AddressConfig result = ParseAddressConfig("HOSTADDR.CFG", bytes, "ERS-210");
  Render(result.diagnostics);
  for (const AddressPair& pair : result.pairs) {
    AddressPair again;
    FuzzCheck(
        ParseAddressPair(AddressText(pair.robot) + "=" + AddressText(pair.host), &again).empty() &&
            again == pair,
        "a pair is not read again");
  }
  return result.pairs.size() > 2 && result.pairs[1].host == 1u << 24;
}

}  // namespace openr_host
