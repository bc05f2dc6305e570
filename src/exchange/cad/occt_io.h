#pragma once
#include <Standard_Failure.hxx>
#include <mutex>
#include <string>

#include "core/error.h"
#include "core/progress.h"
#include "geometry/occt/occt_progress.h"

namespace blossom {

/// Lock for OCCT's translators, whose settings are global and whose units are static: while one exists, only its thread uses
/// them. Also suppresses their output to stdout.
class OcctSession {
 public:
  OcctSession();

 private:
  std::unique_lock<std::recursive_mutex> lock_;
};

/// Sets one of OCCT's global settings ("write.step.schema") and restores it in the destructor. Requires an OcctSession.
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

/// Number format for OCCT's writers with enough digits to read back the same double; the default has 12. Trailing zeros must
/// be kept: OCCT 7.6 drops the exponent of numbers this long when it suppresses them.
inline constexpr const char* exactNumber = "%.16E";

/// Calls `work` and converts an exception of OCCT to an Error with `code` and `sentence`.
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
