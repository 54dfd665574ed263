#include "view/vtk_errors.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkXMLPolyDataReader.h>

namespace lrcs {
namespace {

TEST(VtkErrors, AreKeptAndNotPrinted) {
  testing::internal::CaptureStderr();
  const VtkErrors errors;
  EXPECT_FALSE(errors.any());
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName("/nonexistent/file.vtp");
  reader->Update();
  EXPECT_TRUE(errors.any());
  EXPECT_EQ(errors.first().find('\n'), std::string::npos);
  EXPECT_NE(errors.first().find("/nonexistent/file.vtp"), std::string::npos) << errors.first();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace lrcs
