#include "view/vtk_errors.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <algorithm>

namespace lrcs {
namespace {

// "ERROR: In file, line 1\nvtkThing (0x5): what went wrong\n\n" -> "what went wrong"
std::string message_in(const std::string& text) {
  const std::size_t line = text.find('\n');
  const std::size_t colon = text.find("): ", line == std::string::npos ? 0 : line);
  std::string message = text.substr(colon == std::string::npos ? 0 : colon + 3);
  while (!message.empty() && message.back() == '\n') message.pop_back();
  std::replace(message.begin(), message.end(), '\n', ' ');
  return message;
}

}  // namespace

class KeptMessages : public vtkOutputWindow {
 public:
  static KeptMessages* New();

  void DisplayText(const char* /*text*/) override {}
  void DisplayWarningText(const char* /*text*/) override {}
  void DisplayGenericWarningText(const char* /*text*/) override {}
  void DisplayDebugText(const char* /*text*/) override {}
  void DisplayErrorText(const char* text) override {
    if (first.empty()) first = message_in(text);
  }

  std::string first;
};

KeptMessages* KeptMessages::New() {
  VTK_STANDARD_NEW_BODY(KeptMessages);
}

struct VtkErrors::Hidden {
  vtkSmartPointer<KeptMessages> kept = vtkSmartPointer<KeptMessages>::New();
  vtkSmartPointer<vtkOutputWindow> window_before = vtkOutputWindow::GetInstance();
  vtkLogger::Verbosity verbosity_before = vtkLogger::GetCurrentVerbosityCutoff();
};

VtkErrors::VtkErrors() : hidden_(std::make_unique<Hidden>()) {
  vtkOutputWindow::SetInstance(hidden_->kept);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkErrors::~VtkErrors() {
  vtkLogger::SetStderrVerbosity(hidden_->verbosity_before);
  vtkOutputWindow::SetInstance(hidden_->window_before);
}

bool VtkErrors::any() const {
  return !hidden_->kept->first.empty();
}

std::string VtkErrors::first() const {
  return hidden_->kept->first;
}

}  // namespace lrcs
