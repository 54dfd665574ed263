#include "view/facets_vtp.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <stdexcept>

#include "base/whole_file.h"
#include "view/vtk_errors.h"

namespace lrcs {
namespace {

void require_one_a_facet(std::size_t found, const FacetMesh& mesh, const char* name) {
  if (found != mesh.size()) throw std::invalid_argument(std::string(name) + ": one entry a facet is needed");
}

void require_valid(const FacetMesh& mesh, const FacetResult& result) {
  require_one_a_facet(mesh.part.of.size(), mesh, "part");
  require_one_a_facet(mesh.source_facet.size(), mesh, "source_facet");
  require_one_a_facet(result.material.size(), mesh, "material");
  require_one_a_facet(result.seen_fraction.size(), mesh, "seen_fraction");
  require_one_a_facet(result.sigma_m2.size(), mesh, "sigma_m2");
}

vtkSmartPointer<vtkPoints> points_of(const FacetMesh& mesh, double scale) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vec3& position : mesh.positions) {
    const Vec3 p = scale * position;
    points->InsertNextPoint(p.data());
  }
  return points;
}

vtkSmartPointer<vtkCellArray> triangles_of(const FacetMesh& mesh) {
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& facet : mesh.facets) triangles->InsertNextCell({facet[0], facet[1], facet[2]});
  return triangles;
}

template <class Array, class Values>
vtkSmartPointer<Array> array_of(const char* name, const Values& values) {
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (const auto& value : values) array->InsertNextValue(value);
  return array;
}

// What ParaView calls the array's unit.
template <class Values>
vtkSmartPointer<vtkDoubleArray> array_of(const char* name, const Values& values, const char* unit) {
  auto array = array_of<vtkDoubleArray>(name, values);
  array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), unit);
  return array;
}

vtkSmartPointer<vtkPolyData> facets_of(const FacetMesh& mesh, double scale) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_of(mesh, scale));
  data->SetPolys(triangles_of(mesh));
  return data;
}

void add_cell_arrays(vtkCellData* cells, const FacetMesh& mesh, const FacetResult& result) {
  cells->AddArray(array_of<vtkUnsignedIntArray>("part", mesh.part.of));
  cells->AddArray(array_of<vtkUnsignedIntArray>("material", result.material));
  cells->AddArray(array_of<vtkUnsignedIntArray>("source_facet", mesh.source_facet));
  cells->AddArray(array_of("seen_fraction", result.seen_fraction, "1"));
  cells->AddArray(array_of("sigma_m2", result.sigma_m2, "m2"));
  cells->SetActiveScalars("sigma_m2");
}

void add_field_arrays(vtkFieldData* fields, const FacetMesh& mesh, const FacetResult& result) {
  using Single = std::vector<double>;
  fields->AddArray(array_of<vtkStringArray>("part_names", mesh.part.names));
  fields->AddArray(array_of<vtkStringArray>("material_names", result.material_names));
  fields->AddArray(array_of("transmitter_azimuth_deg", Single{result.transmitter_azimuth_deg}, "degree"));
  fields->AddArray(array_of("transmitter_elevation_deg", Single{result.transmitter_elevation_deg}, "degree"));
  fields->AddArray(array_of("receiver_azimuth_deg", Single{result.receiver_azimuth_deg}, "degree"));
  fields->AddArray(array_of("receiver_elevation_deg", Single{result.receiver_elevation_deg}, "degree"));
  fields->AddArray(array_of("sigma_total_m2", Single{result.sigma_total_m2}, "m2"));
}

void add_words(vtkCellData* cells, const std::string& name, const FacetNames& told) {
  if (told.of.empty() || std::all_of(told.names.begin(), told.names.end(), [](const auto& n) { return n.empty(); }))
    return;
  auto words = vtkSmartPointer<vtkStringArray>::New();
  words->SetName(name.c_str());
  for (const std::uint32_t k : told.of) words->InsertNextValue(told.names[k]);
  cells->AddArray(words);
}

void write_vtp(const std::filesystem::path& vtp, vtkPolyData* data) {
  const VtkErrors errors;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->WriteToOutputStringOn();
  const bool encoded = writer->Write() == 1;
  if (!encoded || errors.any()) throw std::runtime_error(vtp.string() + ": cannot be written: " + errors.first());
  write_whole_file(vtp, writer->GetOutputString());
}

}  // namespace

void write_facets_vtp(const std::filesystem::path& vtp, const FacetMesh& mesh, const FacetResult& result) {
  require_valid(mesh, result);
  const auto data = facets_of(mesh, mesh.metres_per_unit);
  add_cell_arrays(data->GetCellData(), mesh, result);
  add_field_arrays(data->GetFieldData(), mesh, result);
  write_vtp(vtp, data);
}

void write_mesh_vtp(const std::filesystem::path& vtp, const FacetMesh& mesh) {
  const auto data = facets_of(mesh, 1.0);
  vtkCellData* cells = data->GetCellData();
  cells->AddArray(array_of<vtkUnsignedIntArray>("part", mesh.part.of));
  cells->AddArray(array_of<vtkUnsignedIntArray>("source_facet", mesh.source_facet));
  data->GetFieldData()->AddArray(array_of<vtkStringArray>("part_names", mesh.part.names));
  add_words(cells, "file_material", mesh.file_material);
  add_words(cells, "colour", mesh.colour);
  add_words(cells, "layer", mesh.layer);
  // Those of a file that was written here before have these names.
  for (const FacetProperty& property : mesh.properties)
    if (!cells->HasArray(property.name.c_str())) add_words(cells, property.name, property.values);
  write_vtp(vtp, data);
}

}  // namespace lrcs
