#include "runtime/core/image_object.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>

#include <cstring>
#include <filesystem>

#include "runtime/base/assert.h"
#include "runtime/config/ocf.h"
#include "runtime/core/code_place.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/image_file.h"
#include "runtime/core/image_rebase.h"
#include "runtime/core/imported_calls.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/run_folder.h"
#include "runtime/core/system.h"

#if defined(__SANITIZE_ADDRESS__)
// Keeps LeakSanitizer from reporting leaks of objects.  Objects need not free their memory, because
// without sanitizers their heap is freed as a whole.  With AddressSanitizer objects use the host's
// heap, where memory that is not freed is a leak.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:openr_host::ImageObject::Dispatch\nleak:openr_host::ImageObject::Load\n";
}
#endif

namespace openr_host {

ImageObject::~ImageObject() {
  files().CloseAll();
  const CurrentScope scope(system, this);
  // Runs no code of the program, because objects register no destructors (process_hooks.cc).
  if (handle_ != nullptr) dlclose(handle_);
  if (has_thunks_) munmap(memory().addresses()->thunks(), ObjectAddresses::kThunkBytes);
}

std::string ImageObject::Load(const std::string& file, RunFolder* folder) {
  // Names the object after its file until its .ocf text is read, for messages about a crash.
  name = std::filesystem::path(file).filename();
  std::string copy, problem;
  {
    ImageFile image = ReadImageFile(file);
    if (!image.problem.empty()) return image.problem;
    if (const std::string library = SanitizerOf(image.bytes);
        !library.empty() && !IsAddressSanitized()) {
      return fmt::format(
          "was built with --sanitize, and this program has no AddressSanitizer; start it with "
          "LD_PRELOAD={}, or build the object without --sanitize",
          library);
    }
    copy = folder->AddCopy(file, image.bytes, &problem);
    if (copy.empty()) return problem;
    MoveToOwnAddresses(&image.bytes);
    problem = folder->WriteCopy(copy, image.bytes);
    if (!problem.empty()) return problem;
  }
  {
    const CurrentScope scope(system, this);
    handle_ = dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (handle_ == nullptr) {
    return fmt::format(
        "cannot be loaded: {}; an image of another version of openr-host has to be built again",
        dlerror());
  }
  folder->RestoreOriginal(copy);
  problem = CheckVersions();
  if (problem.empty()) problem = ReadOcf();
  if (problem.empty()) problem = RedirectOwnImports();
  if (problem.empty()) problem = RunConstructors();
  return problem.empty() ? ReadTables() : problem;
}

// If addresses are planned (address_plan.h), gives planned addresses to the image, its heap and its
// stack.  Changes `bytes`, the content of the image, so that the loader puts the image at its
// planned address.  If an image cannot be changed in this way, the kernel chooses its load address;
// its heap and stack still get planned addresses.
void ImageObject::MoveToOwnAddresses(std::string* bytes) {
  HoldConstructors(bytes);
  // Keeps the destructors of an image with AddressSanitizer, because they tell AddressSanitizer
  // that the global variables of the image are gone.
  if (!IsAddressSanitized()) DropDestructors(bytes);
  auto taken = std::make_unique<ObjectAddresses>(id);
  if (taken->heap() == nullptr) return;
  memory().Plan(std::move(taken), &system->robot(robot).memory);
  if (system->options().find_leaks) memory().arena()->KeepCalls();
  const ObjectAddresses& addresses = *memory().addresses();
  // Under Valgrind the image is not moved, because Valgrind expects that debug information matches
  // the addresses in the file.
  if (!IsUnderValgrind())
    RebaseImage(bytes, reinterpret_cast<uintptr_t>(addresses.image()),
                ObjectAddresses::kImageBytes);
  stack_ = std::make_unique<HandlerStack>(addresses.stack(0));
}

// Returns "", or why the image does not fit this runtime: it has no description, or was built for
// another version.  Called before any code of the image runs, because code that was compiled with
// other headers may write beyond the end of C++ objects of the runtime.
std::string ImageObject::CheckVersions() {
  info_ = static_cast<const ImageInfo*>(dlsym(handle_, "openr_image_info"));
  if (info_ == nullptr) return "has no openr_image_info; build it with openr build";
  if (info_->version != kImageVersion) {
    return fmt::format(
        "was built for version {} of the image format, this is version {}; build it again",
        info_->version, kImageVersion);
  }
  // Accepts version 0 of the SDK headers: old builds did not write a version into images, and these
  // images may fit.
  const uint32_t headers = info_->headers_version;
  if (headers == 0 || headers == kHeadersVersion) return "";
  return fmt::format(
      "was built with version {} of the headers of openr-host, this is version {}; build all its "
      "sources again",
      headers, kHeadersVersion);
}

// Sets the object's name and limits.  Returns "", or why the image's .ocf text cannot be used.
std::string ImageObject::ReadOcf() {
  const OcfResult ocf = ParseOcf(path + " (.ocf)", info_->ocf);
  if (!ocf.ocf) return "has a bad .ocf text: " + Render(ocf.diagnostics);
  name = ocf.ocf->name;
  set_limits({ocf.ocf->priority, static_cast<uint32_t>(ocf.ocf->stack_bytes),
              static_cast<uint32_t>(ocf.ocf->heap_bytes)});
  return "";
}

// Makes the functions that the image imports run on another stack than the image's own functions.
// Does nothing if a memory checker, such as Valgrind, watches the stack.  Does nothing either if
// the image is not at its planned address, because RedirectImports() works only there.  Returns ""
// or the reason of a failure.
std::string ImageObject::RedirectOwnImports() {
  const char* const info = static_cast<const char*>(dlsym(handle_, "ObjectEntryTable"));
  const ObjectAddresses* const addresses = memory().addresses();
  if (addresses == nullptr || IsStackWatched() || info < addresses->image() ||
      info >= addresses->image() + ObjectAddresses::kImageBytes)
    return "";
  has_thunks_ = true;
  return RedirectImports(addresses->image(), addresses->thunks(), ObjectAddresses::kThunkBytes);
}

std::string ImageObject::RunConstructors() {
  // While the constructors run, results that would be denormal numbers become 0, as on the robot.
  // Otherwise the constructors could store denormal numbers, and a handler that uses them would be
  // reported, although the robot would not stop.  Not done with AddressSanitizer or under Valgrind,
  // where this is not done for handlers either.
  FpScope fp;
  if (!IsStackWatched()) fp.Flush();
  for (void (*const constructor)() : HeldConstructors(handle_)) {
    const CurrentScope scope(system, this, true);
    try {
      Run(reinterpret_cast<void (*)(void*)>(constructor), nullptr);
    } catch (const std::exception& e) {
      return fmt::format("has a global object whose constructor throws an exception: {}", e.what());
    } catch (...) {
      return "has a global object whose constructor throws an exception";
    }
  }
  return "";
}

// Calls `function` of the image on the stack of this object, or on the current stack if the object
// has no stack of its own.
void ImageObject::Run(void (*function)(void*), void* argument) {
  if (stack_ == nullptr) {
    function(argument);
  } else {
    stack_->Call(function, argument);
  }
}

std::string ImageObject::ReadTables() {
  const auto* const table = static_cast<const ObjectEntry*>(dlsym(handle_, "ObjectEntryTable"));
  if (table == nullptr) return "has no ObjectEntryTable; build it with openr build";
  for (const ObjectEntry* entry = table; entry->selector != UNDEF; ++entry) {
    if (entry->selector >= kSelectorMax) {
      return fmt::format(
          "ContextManager::InitObjectEntry selector out of range: sel={}, size={}; "
          "an object has 4 selectors of the system, 2 for each subject and "
          "observer, and 1 for each Extra line: put services together",
          entry->selector, kSelectorMax);
    }
    if (entry->selector >= entries_.size()) entries_.resize(entry->selector + 1, nullptr);
    entries_[entry->selector] = entry->entry;
  }
  // Counts only the entries before the first gap in the object's table of entries, because
  // Object::entry_count() must not count entries that do not exist.
  uint32_t count = 0;
  while (ImageObject::HasEntry(count)) ++count;
  set_entry_count(count);
  const auto* extras = static_cast<const char* const*>(dlsym(handle_, "openr_extra_names"));
  int extra_count = 0;
  while (extras != nullptr && extras[extra_count] != nullptr) ++extra_count;
  // Extra entries, which stub.cfg declares besides the services, come last in the table of entries
  // (SDK reference, section 1.3).  So their selectors are the last `extra_count` numbers.
  const auto first_extra =
      static_cast<uint32_t>(entries_.size()) - static_cast<uint32_t>(extra_count);
  for (int i = 0; i < extra_count; ++i)
    entry_names().SetName(first_extra + static_cast<uint32_t>(i), extras[i]);
  return "";
}

bool ImageObject::HasCode(const void* address) const {
  // Compares `address` with an address that is surely in the image, the address of its table of
  // entries.  If both lie in the same loaded library, that is, if dladdr() gives the same base
  // address for both, `address` belongs to the image.
  Dl_info own{}, other{};
  return !entries_.empty() && dladdr(dlsym(handle_, "ObjectEntryTable"), &own) != 0 &&
         dladdr(address, &other) != 0 && own.dli_fbase == other.dli_fbase;
}

bool ImageObject::HasEntry(uint32_t selector) const {
  return selector < entries_.size() && entries_[selector] != nullptr;
}

bool ImageObject::Dispatch(uint32_t selector, void* payload) {
  if (!HasEntry(selector)) return false;
  if (FpFlags() != 0) ClearFpFlags();  // clears flags of code that ran before this handler
  number_faults().BeginHandler();
  ArithmeticWatch* const watch = t_current.watch;
  if (watch != nullptr && !watch->has_begun()) watch->Begin(kFpCaught & ~fp_seen_);
  Run(reinterpret_cast<void (*)(void*)>(entries_[selector]), payload);
  return true;
}

// Adds findings about floating-point operations that would stop the robot's processor
// (field-notes.md, 4.4).  Each kind of operation is reported once per object.
void ImageObject::ReportFpFlags(uint32_t selector) {
  const ApiScope scope;
  // A conversion to an integer that checked_code.cc has reported sets the flag kFpInvalid (an
  // operation without a valid result).  Does not report this conversion a second time.
  const unsigned reported = number_faults().has_reported_cast() ? unsigned{kFpInvalid} : 0u;
  const unsigned fresh = FpFlags() & ~fp_seen_ & ~reported;
  const bool makes_denormals = ((fp_seen_ | fresh) & kFpUnderflow) != 0;
  fp_seen_ |= fresh;
  const auto warn = [&](unsigned kind, const char* what, const char* then) {
    const std::string place = NameOfPlace(number_faults().InstructionOf(kind));
    system->AddFindingAbout(
        this, Severity::kWarning,
        fmt::format("{}{}{}: {}; {}: exception 15, the robot powers off", EntryName(selector),
                    place.empty() ? "" : ", at ", place, what, then));
  };
  if (fresh & kFpInvalid) {
    warn(kFpInvalid,
         "a floating-point operation made NaN (0/0, sqrt(-1), inf - inf) or converted a number "
         "that its integer type does not hold",
         "the robot stops when such a NaN is used, in isnan() and printf() too");
  }
  if (fresh & (kFpDivByZero | kFpOverflow)) {
    warn((fresh & kFpDivByZero) != 0 ? kFpDivByZero : kFpOverflow,
         "a floating-point operation made an infinity (division by 0, log(0), a result too large)",
         "the robot is said to stop when it is used");
  }
  // A denormal number is nearer to 0 than the processor's normal numbers.  The robot stops when an
  // operation uses a denormal number, for example an int taken for a float.  But the operations of
  // the robot never make denormal numbers: they return 0 instead.
  //
  // With an ArithmeticWatch the host's operations return 0, too, so a denormal number that the
  // watch has found (`is_found`) is reported.  Without a watch the host's operations may have made
  // the denormal number that was used.  So it is reported only if no operation of this object has
  // made denormal numbers.
  const bool is_found = number_faults().InstructionOf(kFpDenormal) != nullptr;
  if ((fresh & kFpDenormal) && (is_found || !makes_denormals)) {
    warn(kFpDenormal,
         "a denormal number was used in a floating-point operation (an int taken for a float, "
         "memory never set?)",
         "the robot stops");
  }
}

// Adds a finding about a division of the smallest integer by -1.  The finding is a warning with
// --strict, too, because the robot does not stop there (docs/limits.md).
void ImageObject::ReportTooLargeQuotient(uint32_t selector) {
  const ApiScope scope;
  const std::string place = NameOfPlace(number_faults().TakeTooLargeQuotient());
  system->AddFindingAbout(
      this, Severity::kWarning,
      fmt::format("{}{}{}: the smallest integer was divided by -1, and the quotient is too large "
                  "for its type: C++ leaves the result open; the robot does not stop, and the run "
                  "goes on with the smallest integer and the remainder 0",
                  EntryName(selector), place.empty() ? "" : ", at ", place));
}

}  // namespace openr_host
