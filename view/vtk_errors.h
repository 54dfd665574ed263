#pragma once
#include <memory>
#include <string>

namespace lrcs {

// While one lives, VTK's warnings and errors are kept here and reach neither stderr nor VTK's log.
// VTK knows one such place in the whole process: use it in one thread at a time.
class VtkErrors {
 public:
  VtkErrors();
  ~VtkErrors();
  VtkErrors(const VtkErrors&) = delete;
  VtkErrors& operator=(const VtkErrors&) = delete;

  // Errors only; a warning alone stops nothing.
  [[nodiscard]] bool any() const;
  // The first error as one line, without VTK's file names and addresses; "" if there is none.
  [[nodiscard]] std::string first() const;

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

}  // namespace lrcs
