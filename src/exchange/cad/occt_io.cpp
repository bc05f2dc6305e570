#include "exchange/cad/occt_io.h"

#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Controller.hxx>

namespace blossom {

namespace {

std::recursive_mutex& translatorMutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

}  // namespace

OcctSession::OcctSession() : lock_(translatorMutex()) {
  static const bool once = [] {
    Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
    STEPControl_Controller::Init();  // the settings exist only after these
    IGESControl_Controller::Init();
    return true;
  }();
  (void)once;
}

OcctSetting::OcctSetting(const char* name, int value) : OcctSetting(name, std::to_string(value).c_str()) {}

OcctSetting::OcctSetting(const char* name, const char* value) : name_(name) {
  if (!Interface_Static::IsPresent(name)) throw Error(ErrorCode::Internal, std::string("OCCT has no setting ") + name + ".");
  before_ = Interface_Static::CVal(name);
  if (!Interface_Static::SetCVal(name, value))
    throw Error(ErrorCode::Internal, std::string("OCCT refuses the value ") + value + " of its setting " + name + ".");
}

OcctSetting::~OcctSetting() { Interface_Static::SetCVal(name_, before_.c_str()); }

}  // namespace blossom
