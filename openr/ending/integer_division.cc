#include "openr/ending/integer_division.h"

#include <cstring>

namespace openr_host {

#if defined(__x86_64__)

namespace {

// The places of the processor's registers 0 to 15 in the context of a signal handler.
constexpr int kRegisters[] = {REG_RAX, REG_RCX, REG_RDX, REG_RBX, REG_RSP, REG_RBP,
                              REG_RSI, REG_RDI, REG_R8,  REG_R9,  REG_R10, REG_R11,
                              REG_R12, REG_R13, REG_R14, REG_R15};

// Reads the bytes of an instruction.  The processor has read all of them, so they exist.
class CodeReader {
 public:
  explicit CodeReader(uintptr_t begin) : begin_(begin), at_(begin) {}

  uint8_t Peek() const { return *reinterpret_cast<const uint8_t*>(at_); }
  uint8_t Byte() { return Number<uint8_t>(); }
  template <typename T>
  T Number() {
    T number;
    std::memcpy(&number, reinterpret_cast<const void*>(at_), sizeof number);
    at_ += sizeof number;
    return number;
  }
  uintptr_t at() const { return at_; }
  size_t count() const { return at_ - begin_; }

 private:
  const uintptr_t begin_;
  uintptr_t at_;
};

// The bits of the prefix REX of an instruction.
constexpr unsigned kRexWide = 8, kRexIndex = 2, kRexBase = 1;

uintptr_t RegisterOf(const ucontext_t& context, unsigned number) {
  return static_cast<uintptr_t>(context.uc_mcontext.gregs[kRegisters[number]]);
}

// Returns the base plus the scaled index that the byte SIB of an instruction names.  `mode` is the
// field mod of the byte ModRM.
uintptr_t ReadScaledIndex(const ucontext_t& context, unsigned rex, unsigned mode,
                          CodeReader* code) {
  const unsigned sib = code->Byte();
  const unsigned index = ((sib >> 3) & 7) | ((rex & kRexIndex) != 0 ? 8u : 0u);
  uintptr_t address = 0;
  if (index != 4) address = RegisterOf(context, index) << (sib >> 6);  // 4 means: no index
  if ((sib & 7) == 5 && mode == 0)
    return address + static_cast<uintptr_t>(int64_t{code->Number<int32_t>()});
  return address + RegisterOf(context, (sib & 7) | ((rex & kRexBase) != 0 ? 8u : 0u));
}

// Returns the address of the operand in memory that the byte ModRM of an instruction names.  The
// operand is the last part of the instruction.
uintptr_t ReadAddress(const ucontext_t& context, unsigned rex, unsigned mod_rm, CodeReader* code) {
  const unsigned mode = mod_rm >> 6, base = mod_rm & 7;
  if (mode == 0 && base == 5) {  // relative to the next instruction
    const int64_t distance = code->Number<int32_t>();
    return code->at() + static_cast<uintptr_t>(distance);
  }
  uintptr_t address = base == 4 ? ReadScaledIndex(context, rex, mode, code)
                                : RegisterOf(context, base | ((rex & kRexBase) != 0 ? 8u : 0u));
  if (mode == 1) address += static_cast<uintptr_t>(int64_t{code->Number<int8_t>()});
  if (mode == 2) address += static_cast<uintptr_t>(int64_t{code->Number<int32_t>()});
  return address;
}

int64_t SmallestOf(unsigned bits) { return bits == 64 ? INT64_MIN : INT32_MIN; }

// Returns the lower `bits` of `value` as a signed number.
int64_t SignedOf(uintptr_t value, unsigned bits) {
  return bits == 64 ? static_cast<int64_t>(value) : static_cast<int32_t>(value);
}

}  // namespace

std::optional<IntegerDivision> FindDivision(const ucontext_t& context) {
  constexpr uint8_t kDivide = 0xf7;      // an operation with one operand of 32 or 64 bits
  constexpr unsigned kSignedDivide = 7;  // the operation idiv
  CodeReader code(static_cast<uintptr_t>(context.uc_mcontext.gregs[REG_RIP]));
  const unsigned rex = (code.Peek() & 0xf0) == 0x40 ? code.Byte() : 0u;
  if (code.Byte() != kDivide) return std::nullopt;
  const unsigned mod_rm = code.Byte();
  if (((mod_rm >> 3) & 7) != kSignedDivide) return std::nullopt;
  const unsigned bits = (rex & kRexWide) != 0 ? 64 : 32;
  uintptr_t divisor = 0;
  if (mod_rm >> 6 == 3) {
    divisor = RegisterOf(context, (mod_rm & 7) | ((rex & kRexBase) != 0 ? 8u : 0u));
  } else {
    const uintptr_t address = ReadAddress(context, rex, mod_rm, &code);
    std::memcpy(&divisor, reinterpret_cast<const void*>(address), bits / 8);
  }
  return IntegerDivision{code.count(), bits, SignedOf(divisor, bits)};
}

bool IsSmallestByMinusOne(const ucontext_t& context) {
  const std::optional<IntegerDivision> division = FindDivision(context);
  if (!division || division->divisor != -1) return false;
  // The dividend has twice as many bits as the divisor.  Its upper half is in RDX.
  const auto& registers = context.uc_mcontext.gregs;
  const auto lower = static_cast<uintptr_t>(registers[REG_RAX]);
  const auto upper = static_cast<uintptr_t>(registers[REG_RDX]);
  return SignedOf(lower, division->bits) == SmallestOf(division->bits) &&
         SignedOf(upper, division->bits) == -1;
}

bool DivideAsTheRobotDoes(ucontext_t* context) {
  if (!IsSmallestByMinusOne(*context)) return false;
  const IntegerDivision division = *FindDivision(*context);
  auto& registers = context->uc_mcontext.gregs;
  // An instruction with operands of 32 bits sets the upper halves of its results to 0.
  registers[REG_RAX] = division.bits == 64 ? INT64_MIN : static_cast<greg_t>(uint64_t{1} << 31);
  registers[REG_RDX] = 0;
  registers[REG_RIP] += static_cast<greg_t>(division.bytes);
  return true;
}

#else

std::optional<IntegerDivision> FindDivision(const ucontext_t&) { return std::nullopt; }
bool IsSmallestByMinusOne(const ucontext_t&) { return false; }
bool DivideAsTheRobotDoes(ucontext_t*) { return false; }

#endif

}  // namespace openr_host
