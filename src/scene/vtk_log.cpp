#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace blossom {

namespace {

std::mutex guard;
std::vector<std::string> messages;
constexpr std::size_t maximumMessages = 200;

class MemoryLog final : public vtkOutputWindow {
 public:
  static MemoryLog* New();
  vtkTypeMacro(MemoryLog, vtkOutputWindow) void DisplayText(const char* text) override {
    const std::scoped_lock lock(guard);
    if (messages.size() < maximumMessages) messages.emplace_back(text);
  }

 protected:
  MemoryLog() { SetDisplayModeToNever(); }
};
vtkStandardNewMacro(MemoryLog)

}  // namespace

void quietVtk() {
  static std::once_flag once;
  std::call_once(once, [] {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    auto log = vtkSmartPointer<MemoryLog>::New();
    vtkOutputWindow::SetInstance(log);
  });
}

std::vector<std::string> takeVtkMessages() {
  const std::scoped_lock lock(guard);
  return std::exchange(messages, {});
}

}  // namespace blossom
