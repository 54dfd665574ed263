#include "view/facets_vtp.h"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <stdexcept>

#include "png_pixels.h"
#include "two_plates.h"

namespace lrcs {
namespace {

class FacetsVtp : public testing::Test {
 protected:
  void read_back() {
    write_facets_vtp(vtp_, plates_.mesh, plates_.result);
    reader_->SetFileName(vtp_.c_str());
    reader_->Update();
    data_ = reader_->GetOutput();
  }
  [[nodiscard]] double field(const char* name) const { return data_->GetFieldData()->GetArray(name)->GetTuple1(0); }
  [[nodiscard]] std::string name(const char* names, int number) const {
    return vtkStringArray::SafeDownCast(data_->GetFieldData()->GetAbstractArray(names))->GetValue(number);
  }
  template <class Values>
  void expect_cells(const char* array, const Values& values) const {
    vtkDataArray* found = data_->GetCellData()->GetArray(array);
    ASSERT_NE(found, nullptr) << array;
    ASSERT_EQ(found->GetNumberOfTuples(), static_cast<vtkIdType>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
      EXPECT_EQ(found->GetTuple1(static_cast<vtkIdType>(i)), static_cast<double>(values[i])) << array;
    }
  }

  std::filesystem::path vtp_ = scratch_file("facets-0.vtp");
  TwoPlates plates_ = two_plates();
  vtkNew<vtkXMLPolyDataReader> reader_;
  vtkPolyData* data_ = nullptr;
};

TEST_F(FacetsVtp, ReadsBackWithEveryArrayAndExactDoubles) {
  read_back();
  expect_cells("part", plates_.mesh.part.of);
  expect_cells("material", plates_.result.material);
  expect_cells("source_facet", plates_.mesh.source_facet);
  expect_cells("seen_fraction", plates_.result.seen_fraction);
  expect_cells("sigma_m2", plates_.result.sigma_m2);
  EXPECT_EQ(field("receiver_azimuth_deg"), 0.1);
  EXPECT_EQ(field("transmitter_azimuth_deg"), 0.1);
  EXPECT_EQ(field("receiver_elevation_deg"), 0.0);
  EXPECT_EQ(field("transmitter_elevation_deg"), 0.0);
  EXPECT_EQ(field("sigma_total_m2"), plates_.result.sigma_total_m2);
}

TEST_F(FacetsVtp, SaysUnits) {
  read_back();
  const auto unit = [](vtkDataArray* array) {
    vtkInformation* information = array->GetInformation();
    return std::string(information->Has(vtkDataArray::UNITS_LABEL()) ? information->Get(vtkDataArray::UNITS_LABEL())
                                                                     : "none");
  };
  EXPECT_EQ(unit(data_->GetCellData()->GetArray("sigma_m2")), "m2");
  EXPECT_EQ(unit(data_->GetCellData()->GetArray("seen_fraction")), "1");
  EXPECT_EQ(unit(data_->GetCellData()->GetArray("part")), "none");
  EXPECT_EQ(unit(data_->GetFieldData()->GetArray("receiver_azimuth_deg")), "degree");
  EXPECT_EQ(unit(data_->GetFieldData()->GetArray("sigma_total_m2")), "m2");
}

TEST_F(FacetsVtp, KeepsCornersExactlyAndInOrder) {
  read_back();
  ASSERT_EQ(data_->GetNumberOfCells(), 4);
  for (std::size_t facet = 0; facet < 4; ++facet) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const vtkIdType id = data_->GetCell(static_cast<vtkIdType>(facet))->GetPointId(static_cast<int>(corner));
      EXPECT_EQ(Vec3(data_->GetPoint(id)), plates_.mesh.corners(facet)[corner]);
    }
  }
}

TEST_F(FacetsVtp, NamesPartsAndMaterials) {
  read_back();
  EXPECT_EQ(name("part_names", 0), "right");
  EXPECT_EQ(name("part_names", 1), plates_.mesh.part.names[1]);
  EXPECT_EQ(name("material_names", 1), "paint");
}

TEST_F(FacetsVtp, GivesTheSameBytesTwice) {
  const auto again = scratch_file("again.vtp");
  write_facets_vtp(vtp_, plates_.mesh, plates_.result);
  write_facets_vtp(again, plates_.mesh, plates_.result);
  EXPECT_EQ(bytes_of(vtp_), bytes_of(again));
}

TEST_F(FacetsVtp, RefusesArraysOfAnotherLength) {
  plates_.result.sigma_m2.pop_back();
  EXPECT_THROW(write_facets_vtp(vtp_, plates_.mesh, plates_.result), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(vtp_));
}

TEST_F(FacetsVtp, SaysThatItCannotWrite) {
  const auto nowhere = vtp_.parent_path() / "no such folder" / "x.vtp";
  EXPECT_THROW(write_facets_vtp(nowhere, plates_.mesh, plates_.result), std::runtime_error);
}

}  // namespace
}  // namespace lrcs
