#include "runtime/core/imported_calls.h"

#if defined(__x86_64__)

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <vector>

#include "runtime/core/address_plan.h"
#include "runtime/core/stack_memory.h"

// An image calls each imported function through a thunk.  The thunk jumps to openr_call_import or
// openr_call_variadic_import, with the address of the imported function in r11.  This code then:
// 1. Tests the stack pointer.  An image's own stack is below 17 TiB, in the upper part of the
// memory for its stacks (stack_memory.h).  A call from any other stack stays on that stack.
// 2. Changes to the stack for imported functions, at its top.  The word below the top gets the
// address of this call's stack frame on the image's stack.  By this word, ReturnAddressInImage()
// finds the stack frame, which has the return address.
// 3. Copies bytes from the stack of the image, because the imported function looks for some of its
// arguments on the stack.  Their size is not known, so always 256 bytes are copied, or 2 KiB for a
// function with a variable number of arguments (our choice).  The copy uses only registers that
// hold no argument.
// 4. After the call, sets registers without a result to 0, because they may hold host addresses and
// functions of the image may save them on their stack.
extern "C" void openr_call_import();
extern "C" void openr_call_variadic_import();
asm(R"(
    .macro OPENR_CALL_IMPORT argument_bytes
    .cfi_startproc
    movq %rsp, %r10
    shrq $40, %r10
    cmpq $17, %r10
    jae 2f
    movl %esp, %r10d
    andl $0xfffff, %r10d
    cmpl $0xbf000, %r10d
    jb 2f
    pushq %rbp
    .cfi_def_cfa_offset 16
    .cfi_offset %rbp, -16
    movq %rsp, %rbp
    .cfi_def_cfa_register %rbp
    movq %rsp, %r10
    andq $-0x100000, %r10
    addq $0xbe000, %r10
    movq %rbp, -8(%r10)
    leaq -(\argument_bytes + 16)(%r10), %rsp
    movl $(\argument_bytes - 16), %r10d
1:  movups 16(%rbp, %r10), %xmm15
    movups %xmm15, (%rsp, %r10)
    subq $16, %r10
    jae 1b
    callq *%r11
    xorl %ecx, %ecx
    xorl %esi, %esi
    xorl %edi, %edi
    xorl %r8d, %r8d
    xorl %r9d, %r9d
    xorl %r10d, %r10d
    xorl %r11d, %r11d
    movq %rbp, %rsp
    popq %rbp
    .cfi_def_cfa %rsp, 8
    .cfi_restore %rbp
    ret
2:  jmpq *%r11
    .cfi_endproc
    .endm

    .text
    .globl openr_call_import
    .hidden openr_call_import
    .type openr_call_import, @function
openr_call_import:
    OPENR_CALL_IMPORT 256
    .size openr_call_import, .-openr_call_import
    .globl openr_call_variadic_import
    .hidden openr_call_variadic_import
    .type openr_call_variadic_import, @function
openr_call_variadic_import:
    OPENR_CALL_IMPORT 2048
    .size openr_call_variadic_import, .-openr_call_variadic_import
    .globl openr_call_import_end
    .hidden openr_call_import_end
openr_call_import_end:
)");
extern "C" const char openr_call_import_end[];

namespace openr_host {
namespace {

static_assert(ObjectAddresses::kStackBytes == 0x100000);
static_assert(StackMemory::kBottomOffset == 0xbf000);
static_assert(StackMemory::kImportsTopOffset == 0xbe000);

// Functions of the C library that take a variable number of arguments.  For these functions the
// code that changes the stack (a thunk) copies more bytes of arguments.  C++ functions are not
// listed, because a "z" at the end of the mangled name shows a variable number of arguments.
constexpr std::string_view kVariadic[] = {
    "__asprintf_chk",
    "__dprintf_chk",
    "__fprintf_chk",
    "__fwprintf_chk",
    "__isoc23_fscanf",
    "__isoc23_fwscanf",
    "__isoc23_scanf",
    "__isoc23_sscanf",
    "__isoc23_swscanf",
    "__isoc23_wscanf",
    "__isoc99_fscanf",
    "__isoc99_fwscanf",
    "__isoc99_scanf",
    "__isoc99_sscanf",
    "__isoc99_swscanf",
    "__isoc99_wscanf",
    "__printf_chk",
    "__snprintf_chk",
    "__sprintf_chk",
    "__swprintf_chk",
    "__syslog_chk",
    "__wprintf_chk",
    "asprintf",
    "dprintf",
    "err",
    "error",
    "error_at_line",
    "errx",
    "execl",
    "execle",
    "execlp",
    "fprintf",
    "fscanf",
    "fwprintf",
    "fwscanf",
    "makecontext",
    "printf",
    "scanf",
    "snprintf",
    "sprintf",
    "sscanf",
    "strfmon",
    "strfmon_l",
    "swprintf",
    "swscanf",
    "syslog",
    "warn",
    "warnx",
    "wprintf",
    "wscanf",
};

// Functions that keep the stack pointer or the return address of their caller, as setjmp() does for
// longjmp().  They have no thunk (code that changes the stack for a call).  Called by a thunk, they
// would keep the stack pointer or the return address of the thunk.
constexpr std::string_view kBoundToCaller[] = {
    "__sigsetjmp", "_setjmp", "getcontext", "setjmp", "sigsetjmp", "swapcontext", "vfork",
};

static_assert(std::ranges::is_sorted(kVariadic), "IsVariadic() searches by halves");

bool IsVariadic(std::string_view name) {
  if (name.starts_with("_Z")) return name.ends_with('z');
  return std::ranges::binary_search(kVariadic, name);
}

// The address ranges that hold machine code, of this program and of all libraries.  With these
// ranges we distinguish imported functions, which get thunks (code that changes the stack for a
// call), from imported variables, which get none.
class CodeRanges {
 public:
  CodeRanges() { dl_iterate_phdr(&Add, this); }

  bool Contain(uint64_t address) const {
    return std::ranges::any_of(ranges_, [address](const Range& range) {
      return address >= range.begin && address < range.end;
    });
  }

 private:
  struct Range {
    uint64_t begin, end;
  };

  static int Add(dl_phdr_info* info, size_t, void* self) {
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const Elf64_Phdr& segment = info->dlpi_phdr[i];
      if (segment.p_type != PT_LOAD || (segment.p_flags & PF_X) == 0) continue;
      const uint64_t begin = info->dlpi_addr + segment.p_vaddr;
      static_cast<CodeRanges*>(self)->ranges_.push_back({begin, begin + segment.p_memsz});
    }
    return 0;
  }

  std::vector<Range> ranges_;
};

constexpr size_t kThunkBytes = 16;
constexpr uint64_t kLoaderPage = 4096;

// The addresses of a loaded image and of its tables in memory.  The dynamic section lists the
// tables; ValueOf() returns the value of its entry `tag`, or 0 if there is no such entry.
struct LoadedImage {
  explicit LoadedImage(char* image);
  uint64_t ValueOf(int64_t tag) const;

  uint64_t begin, end = 0;
  uint64_t read_only_begin = 0, read_only_end = 0;  // the loader has made this range read-only
  const Elf64_Dyn* dynamic = nullptr;
};

LoadedImage::LoadedImage(char* image) : begin(reinterpret_cast<uint64_t>(image)) {
  const auto* const header = reinterpret_cast<const Elf64_Ehdr*>(image);
  const auto* const segments = reinterpret_cast<const Elf64_Phdr*>(image + header->e_phoff);
  for (int i = 0; i < header->e_phnum; ++i) {
    const Elf64_Phdr& segment = segments[i];
    // Takes p_vaddr, the address of the segment in the image file, for its address in memory,
    // because the image was loaded at the address that its file names.
    if (segment.p_type == PT_LOAD) end = std::max(end, segment.p_vaddr + segment.p_memsz);
    if (segment.p_type == PT_DYNAMIC) dynamic = reinterpret_cast<const Elf64_Dyn*>(segment.p_vaddr);
    if (segment.p_type == PT_GNU_RELRO) {
      read_only_begin = segment.p_vaddr / kLoaderPage * kLoaderPage;
      read_only_end = (segment.p_vaddr + segment.p_memsz) / kLoaderPage * kLoaderPage;
    }
  }
}

uint64_t LoadedImage::ValueOf(int64_t tag) const {
  for (const Elf64_Dyn* entry = dynamic; entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == tag) return entry->d_un.d_val;
  }
  return 0;
}

class Redirection {
 public:
  Redirection(char* image, char* thunks) : image_(image), thunks_(thunks) {}

  std::string Run(size_t bytes_max);

 private:
  struct Import {
    uint64_t* slot;  // the word of the image that holds the address of the function
    uint64_t symbol;
  };

  void FindImports(int64_t table, int64_t size);
  const char* NameOf(uint64_t symbol) const;
  uint64_t MakeThunk(const Import& import, size_t index);

  const LoadedImage image_;
  char* const thunks_;
  const CodeRanges code_;
  std::vector<Import> imports_;
};

const char* Redirection::NameOf(uint64_t symbol) const {
  const auto* const symbols = reinterpret_cast<const Elf64_Sym*>(image_.ValueOf(DT_SYMTAB));
  return reinterpret_cast<const char*>(image_.ValueOf(DT_STRTAB)) + symbols[symbol].st_name;
}

void Redirection::FindImports(int64_t table, int64_t size) {
  const auto* const relocations = reinterpret_cast<const Elf64_Rela*>(image_.ValueOf(table));
  const uint64_t count = relocations == nullptr ? 0 : image_.ValueOf(size) / sizeof(Elf64_Rela);
  for (uint64_t i = 0; i < count; ++i) {
    const Elf64_Rela& relocation = relocations[i];
    const uint64_t type = ELF64_R_TYPE(relocation.r_info);
    // Skips all relocations (places in the image that the loader fills with an address) except
    // those that hold the address of a symbol, because only these can hold the address of an
    // imported function.
    if (type != R_X86_64_JUMP_SLOT && type != R_X86_64_GLOB_DAT && type != R_X86_64_64) continue;
    const Import import{reinterpret_cast<uint64_t*>(relocation.r_offset),
                        ELF64_R_SYM(relocation.r_info)};
    const uint64_t function = *import.slot;
    // Makes no thunks for functions of the image itself, because they run on the image's own stack.
    if (function >= image_.begin && function < image_.end) continue;
    if (!code_.Contain(function)) continue;  // leaves out variables, which need no thunk
    if (std::ranges::count(kBoundToCaller, NameOf(import.symbol)) > 0) continue;
    imports_.push_back(import);
  }
}

// Writes a thunk (code that changes the stack for a call of an imported function) and returns its
// address.  A thunk has two instructions: mov r11, FUNCTION; jmp *WORD.  In front of all thunks lie
// two words with the addresses of openr_call_import and openr_call_variadic_import.  WORD is the
// second word if the function has a variable number of arguments, otherwise the first word.
uint64_t Redirection::MakeThunk(const Import& import, size_t index) {
  char* const thunk = thunks_ + (index + 1) * kThunkBytes;
  const char* const word = thunks_ + (IsVariadic(NameOf(import.symbol)) ? 8 : 0);
  const auto distance = static_cast<int32_t>(word - (thunk + kThunkBytes));
  std::memcpy(thunk, "\x49\xbb", 2);
  std::memcpy(thunk + 2, import.slot, 8);
  std::memcpy(thunk + 10, "\xff\x25", 2);
  std::memcpy(thunk + 12, &distance, 4);
  return reinterpret_cast<uint64_t>(thunk);
}

std::string Redirection::Run(size_t bytes_max) {
  FindImports(DT_JMPREL, DT_PLTRELSZ);
  FindImports(DT_RELA, DT_RELASZ);
  const size_t bytes = (imports_.size() + 1) * kThunkBytes;
  if (bytes > bytes_max) {
    return fmt::format("imports {} functions, {} are possible", imports_.size(),
                       bytes_max / kThunkBytes - 1);
  }
  const auto set_access = [this](int access) {
    return image_.read_only_begin == image_.read_only_end ||
           mprotect(reinterpret_cast<void*>(image_.read_only_begin),
                    image_.read_only_end - image_.read_only_begin, access) == 0;
  };
  constexpr char kNoMemory[] = "has no memory for the calls of imported functions";
  if (!MapAt(thunks_, bytes) || !set_access(PROT_READ | PROT_WRITE)) return kNoMemory;
  const std::array<void (*)(), 2> targets = {&openr_call_import, &openr_call_variadic_import};
  std::memcpy(thunks_, targets.data(), sizeof targets);
  // Makes only one thunk (code that changes the stack for a call) for each imported function, even
  // if several tables of the image name the function.  Programs may compare addresses of functions,
  // so all tables must have the same address for it.
  std::vector<uint64_t> thunks(imports_.size());
  for (size_t i = 0; i < imports_.size(); ++i) {
    const auto same = std::ranges::find(imports_, imports_[i].symbol, &Import::symbol);
    const auto index = static_cast<size_t>(same - imports_.begin());
    thunks[i] = index < i ? thunks[index] : MakeThunk(imports_[i], i);
  }
  // Replaces the addresses of imported functions in the image only in this last step.  If a
  // step before this fails, the image is unloaded.  Unloading runs functions of the image, which
  // need the unchanged addresses.
  if (mprotect(thunks_, bytes, PROT_READ | PROT_EXEC) != 0) return kNoMemory;
  for (size_t i = 0; i < imports_.size(); ++i) *imports_[i].slot = thunks[i];
  return set_access(PROT_READ) ? "" : kNoMemory;
}

}  // namespace

std::string RedirectImports(char* image, char* thunks, size_t bytes) {
  return Redirection(image, thunks).Run(bytes);
}

bool IsStackChange(uintptr_t address) {
  return address >= reinterpret_cast<uintptr_t>(&openr_call_import) &&
         address < reinterpret_cast<uintptr_t>(&openr_call_import_end);
}

const void* ReturnAddressInImage(const void* own) {
  const auto here = reinterpret_cast<uintptr_t>(__builtin_frame_address(0));
  const uintptr_t offset = here % ObjectAddresses::kStackBytes;
  // A function F of the SDK has called this function, and `own` is the return address of F.  If the
  // image has called F through a thunk, F runs on a stack for imported functions.  Such a stack is
  // below 17 TiB, in the lower part of the memory for the image's stacks.  If `here`, the address
  // of this function's frame, is on any other stack, the image has called F directly, so `own` is
  // the result.
  if (here >> 40 >= 17 || offset >= StackMemory::kImportsTopOffset) return own;
  const uintptr_t top = here - offset + StackMemory::kImportsTopOffset;
  const auto* const frame =
      reinterpret_cast<void* const*>(*reinterpret_cast<const uintptr_t*>(top - sizeof(uintptr_t)));
  return frame[1];
}

}  // namespace openr_host

#else

namespace openr_host {

std::string RedirectImports(char*, char*, size_t) { return ""; }
bool IsStackChange(uintptr_t) { return false; }
const void* ReturnAddressInImage(const void* own) { return own; }

}  // namespace openr_host

#endif
