// Divisions of the smallest integer by -1 with all forms of operands that compilers use.
#include "openr/ending/integer_division.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cstdint>

namespace openr_host {
namespace {

#if defined(__x86_64__)

struct Results {
  int64_t quotient;
  int64_t remainder;
  bool operator==(const Results&) const = default;
};
constexpr Results kOf32 = {int64_t{1} << 31, 0};  // the upper halves of the registers are 0
constexpr Results kOf64 = {INT64_MIN, 0};

int g_stops = 0;

// Ends the test if the division is another one, because the instruction would stop for ever.
void GoOn(int, siginfo_t*, void* context) {
  ++g_stops;
  if (!DivideAsTheRobotDoes(static_cast<ucontext_t*>(context))) _exit(3);
}

class IntegerDivisionTest : public testing::Test {
 protected:
  IntegerDivisionTest() {
    g_stops = 0;
    struct sigaction action {};
    action.sa_sigaction = &GoOn;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGFPE, &action, &before_);
  }
  ~IntegerDivisionTest() override {
    sigaction(SIGFPE, &before_, nullptr);
    EXPECT_GT(g_stops, 0);
  }

  struct sigaction before_ {};
};

int32_t g_minus_one = -1;
int64_t g_long_minus_one = -1;

// Expects that the instructions `code` divide the smallest integer, which is in RDX and RAX, by -1.
// They may use the registers R9, R12 and R13; %2, %3 ... are the arguments behind `code`.
#define EXPECT_DIVISION(smallest, expected, code, ...)             \
  do {                                                             \
    Results results = {smallest, -1};                              \
    asm volatile(code                                              \
                 : "+a"(results.quotient), "+d"(results.remainder) \
                 : __VA_ARGS__                                     \
                 : "cc", "memory", "r9", "r12", "r13");            \
    EXPECT_EQ(results, expected) << code;                          \
  } while (false)
#define EXPECT_32(...) EXPECT_DIVISION(0x80000000, kOf32, __VA_ARGS__)
#define EXPECT_64(...) EXPECT_DIVISION(INT64_MIN, kOf64, __VA_ARGS__)

TEST_F(IntegerDivisionTest, ByARegister) {
  EXPECT_32("idivl %%ecx", "c"(-1));
  EXPECT_64("idivq %%rsi", "S"(int64_t{-1}));
  EXPECT_32("movq %2, %%r12; idivl %%r12d", "r"(int64_t{-1}));
  EXPECT_64("movq %2, %%r12; idivq %%r12", "r"(int64_t{-1}));
}

TEST_F(IntegerDivisionTest, ByAVariable) {
  EXPECT_32("idivl %2", "m"(g_minus_one));
  EXPECT_64("idivq %2", "m"(g_long_minus_one));
  const volatile int32_t local = -1;
  const volatile int64_t long_local = -1;
  EXPECT_32("idivl %2", "m"(local));
  EXPECT_64("idivq %2", "m"(long_local));
}

TEST_F(IntegerDivisionTest, ByAnElement) {
  int32_t numbers[300] = {};
  numbers[0] = numbers[5] = numbers[7] = numbers[299] = -1;
  const int64_t index = 5;
  EXPECT_32("idivl (%%rsi)", "S"(numbers));
  EXPECT_32("idivl 28(%%rsi)", "S"(numbers));
  EXPECT_32("idivl -4(%%rsi)", "S"(numbers + 8));
  EXPECT_32("idivl 1196(%%rsi)", "S"(numbers));
  EXPECT_32("idivl (%%rsi,%%rcx,4)", "S"(numbers), "c"(index));
  EXPECT_32("idivl 8(%%rsi,%%rcx,4)", "S"(numbers), "c"(index));
  EXPECT_32("idivl 1176(%%rsi,%%rcx,4)", "S"(numbers), "c"(index));
  EXPECT_32("idivl 20(,%%rcx,4)", "c"(reinterpret_cast<intptr_t>(numbers) / 4));
}

TEST_F(IntegerDivisionTest, ByAnElementThatNewRegistersName) {
  int32_t numbers[8] = {};
  numbers[0] = numbers[5] = numbers[7] = -1;
  const int64_t index = 5;
  EXPECT_32("movq %2, %%r13; idivl (%%r13)", "S"(numbers));
  EXPECT_32("movq %2, %%r12; idivl (%%r12)", "S"(numbers));
  EXPECT_32("movq %2, %%r12; idivl 28(%%r12)", "S"(numbers));
  EXPECT_32("movq %2, %%r13; movq %3, %%r9; idivl (%%r13,%%r9,4)", "S"(numbers), "c"(index));
  EXPECT_32("movq %2, %%r13; movq %3, %%r12; idivl (%%r13,%%r12,4)", "S"(numbers), "c"(index));
}

TEST(OtherDivisionsTest, AreNotTakenForIt) {
  const uint8_t by_register[] = {0xf7, 0xf9};   // idiv ecx
  const uint8_t unsigned_one[] = {0xf7, 0xf1};  // div ecx
  const uint8_t no_division[] = {0x90, 0x90};
  ucontext_t context{};
  auto& registers = context.uc_mcontext.gregs;
  const auto find = [&](const uint8_t* code) {
    registers[REG_RIP] = reinterpret_cast<greg_t>(code);
    return FindDivision(context);
  };
  registers[REG_RAX] = 0x80000000;
  registers[REG_RDX] = 0xffffffff;
  registers[REG_RCX] = 0xffffffff;
  EXPECT_FALSE(find(unsigned_one));
  EXPECT_FALSE(find(no_division));
  ASSERT_TRUE(find(by_register));
  EXPECT_EQ(find(by_register)->divisor, -1);
  EXPECT_EQ(find(by_register)->bytes, 2u);
  EXPECT_TRUE(IsSmallestByMinusOne(context));
  registers[REG_RCX] = 0;
  EXPECT_FALSE(IsSmallestByMinusOne(context));
  EXPECT_FALSE(DivideAsTheRobotDoes(&context));
  registers[REG_RCX] = 0xffffffff;
  registers[REG_RAX] = 0x80000001;
  EXPECT_FALSE(IsSmallestByMinusOne(context));
  EXPECT_EQ(registers[REG_RAX], 0x80000001);
}

#endif

}  // namespace
}  // namespace openr_host
