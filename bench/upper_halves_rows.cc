// A row that shows what ClearUpperRegisters() (runtime/base/upper_registers.h) is worth on this
// processor: a step of the body after code for AVX has left bits in the upper halves of the vector
// registers, with and without the call.
//
// The program makes this call at the beginning of a step in the world with physics (PhysicsWorld),
// where it cannot be left out.  So the row calls what is below: the functions of OdeBody that make
// up a step of a robot without contacts.  A hand holds the dog in the air.
#include <memory>

#include "bench/bench.h"
#include "bench/dogs.h"
#include "runtime/base/upper_registers.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

#if defined(__x86_64__) && !defined(__AVX__)

bool CanSetUpperHalves() { return __builtin_cpu_supports("avx"); }

// Sets all bits of the upper halves of the 16 vector registers, as code for AVX may leave them.
void SetUpperHalves() {
  asm volatile(
      "vpcmpeqd %%xmm0, %%xmm0, %%xmm0\n\t"
      ".irp number, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15\n\t"
      "vinsertf128 $1, %%xmm0, %%ymm0, %%ymm\\number\n\t"
      ".endr"
      :
      :
      : "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10",
        "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");
}

#else

bool CanSetUpperHalves() { return false; }
void SetUpperHalves() {}

#endif

// A dog that a hand holds in the air.
class HeldBody {
 public:
  // `sets` is true if the upper halves are set before each step, `clears` is true if they are then
  // cleared, as the program does.
  HeldBody(const std::string& stick, bool sets, bool clears)
      : sets_(sets), clears_(clears), dog_(stick), body_(dog_.MakeBody()) {
    Eigen::Isometry3d X_WB = dog_.X_WB();
    X_WB.translation().z() += kHeight_m;
    body_->Hold(X_WB);
  }

  void Run(int64_t frames) {
    for (; frames > 0; --frames) {
      if (sets_) SetUpperHalves();
      if (clears_) ClearUpperRegisters();
      Step();
    }
    ClearUpperRegisters();  // because other variants follow
  }

 private:
  static constexpr double kHeight_m = 0.3;

  // Does the same as PhysicsWorld::Advance() for a robot that touches nothing.
  void Step() {
    static const std::vector<double> kNoImpulses;
    body_->SetCommands(dog_.commands());
    body_->BeginFrame();
    body_->BeginStep(kFrame_s);
    body_->tree().EndStep(kNoImpulses);
    body_->EndStep();
    body_->EndFrame();
  }

  const bool sets_, clears_;
  const StandingDog dog_;
  const std::unique_ptr<OdeBody> body_;
};

}  // namespace

std::vector<Row> UpperHalvesRows(const std::string& stick) {
  Row row{"upper halves; a step of the body in the air", "ns a step", 2500};
  row.warm_up = row.count / 10;
  if (!CanSetUpperHalves()) {
    row.note = "not measured: no upper halves (no x86-64, no AVX, or a build for AVX)";
    return {row};
  }
  const auto variant = [stick](const char* name, bool sets, bool clears) {
    return Lazily<HeldBody>(name, [=] { return std::make_unique<HeldBody>(stick, sets, clears); });
  };
  row.variants = {variant("clean", false, true), variant("set, cleared as in a run", true, true),
                  variant("set, not cleared", true, false)};
  return {row};
}

}  // namespace openr_host
