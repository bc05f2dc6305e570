#pragma once
#include <Standard_Failure.hxx>
#include <mutex>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "geometry/occt/occt_progress.h"

namespace blossom {

/// While one lives, its thread alone uses OCCT's translators, whose settings are global and whose units are static. Also
/// keeps them from printing to stdout.
class OcctSession {
 public:
  OcctSession();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// One of OCCT's global settings ("write.step.schema"), put back at the end. Needs an OcctSession.
class OcctSetting {
 public:
  OcctSetting(const char* name, int value);
  OcctSetting(const char* name, const char* value);
  ~OcctSetting();
  OcctSetting(const OcctSetting&) = delete;
  OcctSetting& operator=(const OcctSetting&) = delete;

 private:
  const char* name_;
  std::string before_;
};

/// Format by which OCCT's writers give numbers enough digits to be read back as the same double; their own has 12.
/// Trailing zeros must stay: suppressing them, OCCT 7.6 drops the exponent of numbers this long.
inline constexpr const char* exactNumber = "%.16E";

/// Calls `work`; an exception of OCCT comes out as an Error with `code` and `sentence`.
template <class Work>
auto withOcctErrors(ErrorCode code, const std::string& sentence, Work&& work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    const std::string reason = failure.GetMessageString();
    throw Error(code, sentence,
                "The geometry kernel says: " + (reason.empty() ? failure.DynamicType()->Name() : reason) + ".");
  }
}

}  // namespace blossom
