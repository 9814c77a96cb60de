#include "openr/ending/code_lookup.h"

#include <cxxabi.h>
#include <dlfcn.h>
#include <elfutils/libdwfl.h>

#include <cstdlib>
#include <memory>
#include <string_view>

#include "runtime/core/current.h"

namespace openr_host {
namespace {

using Session = std::unique_ptr<Dwfl, decltype(&dwfl_end)>;

// The load address that we tell libdwfl for a shared object.  Any address is good, because
// instructions are looked up by their distance from this address.
constexpr GElf_Addr kBase = 0x10000;

std::string Readable(const char* symbol) {
  int status = 0;
  char* const name = abi::__cxa_demangle(symbol, nullptr, nullptr, &status);
  std::string result = status == 0 ? name : symbol;
  std::free(name);
  return result;
}

std::string LineOf(Dwfl_Module* module, GElf_Addr address) {
  Dwfl_Line* const line = dwfl_module_getsrc(module, address);
  int number = 0;
  const char* const file =
      line == nullptr ? nullptr : dwfl_lineinfo(line, nullptr, &number, nullptr, nullptr, nullptr);
  if (file == nullptr || number == 0) return "";
  const std::string_view path = file;
  return std::string(path.substr(path.rfind('/') + 1)) + ":" + std::to_string(number);
}

}  // namespace

CodeLookup LookUpCode(const char* file, uintptr_t offset) {
  // Lets no object be the current object until this function returns, so that malloc() and fopen()
  // use the heap and the files of the host, not those of the object that has crashed.
  const CurrentScope scope(nullptr, nullptr);
  // Makes libdwfl search debug information only beside the image file.  Other folders, with
  // installed debug packages, are not searched, because the output of a run would then differ from
  // machine to machine.
  static char only_beside[] = ":.";
  static char* path = static_cast<char*>(only_beside);
  static const Dwfl_Callbacks kCallbacks = {.find_elf = nullptr,
                                            .find_debuginfo = &dwfl_standard_find_debuginfo,
                                            .section_address = nullptr,
                                            .debuginfo_path = &path};
  const Session session(dwfl_begin(&kCallbacks), &dwfl_end);
  if (session == nullptr) return {};
  dwfl_report_begin(session.get());
  Dwfl_Module* const module =
      dwfl_report_elf(session.get(), file, file, -1, kBase, /*add_p_vaddr=*/false);
  dwfl_report_end(session.get(), nullptr, nullptr);
  if (module == nullptr) return {};
  // The number that libdwfl adds to the addresses in the file: kBase for a shared object, 0 for a
  // program that was linked for fixed addresses.
  GElf_Addr added = 0;
  if (dwfl_module_getelf(module, &added) == nullptr) return {};
  const GElf_Addr address = added + offset;
  CodeLookup result;
  if (const char* const name = dwfl_module_addrname(module, address))
    result.function = Readable(name);
  result.line = LineOf(module, address);
  return result;
}

std::string LineOfAddress(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || info.dli_fname == nullptr) return "";
  const auto offset =
      reinterpret_cast<uintptr_t>(address) - reinterpret_cast<uintptr_t>(info.dli_fbase);
  return LookUpCode(info.dli_fname, offset).line;
}

}  // namespace openr_host
