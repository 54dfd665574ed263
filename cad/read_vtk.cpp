#include "cad/read_vtk.h"

#include <fmt/format.h>
#include <vtkAbstractArray.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>

#include "base/input_error.h"
#include "base/length.h"
#include "mesh/file_normals.h"
#include "mesh/mesh_builder.h"
#include "mesh/polygon_words.h"

namespace lrcs {
namespace {

// VTK's readers say what is wrong by an event.
void keep_first(vtkObject* /*from*/, unsigned long /*event*/, void* to, void* said) {
  auto& words = *static_cast<std::string*>(to);
  if (!words.empty() || said == nullptr) return;
  words = static_cast<const char*>(said);
  // "ERROR: In file, line n\nclass (0x...): words\n\n"
  if (const std::size_t begin = words.find("): "); begin != std::string::npos) words.erase(0, begin + 3);
  std::replace(words.begin(), words.end(), '\n', ' ');
  words.erase(words.find_last_not_of(' ') + 1);
}

template <class Reader>
void read_with(Reader* reader, const std::string& file) {
  std::string complaint;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetCallback(keep_first);
  listener->SetClientData(&complaint);
  reader->AddObserver("ErrorEvent", listener);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!complaint.empty() || reader->GetErrorCode() != 0)
    throw InputError(Place{file}, fmt::format("cannot be read: {}", complaint.empty() ? "damaged" : complaint));
}

bool is_grid(const std::string& file) {
  std::string head(4096, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  return head.find("UnstructuredGrid") != std::string::npos;
}

vtkSmartPointer<vtkPolyData> surface_of(const std::string& file) {
  if (is_grid(file)) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read_with(reader.Get(), file);
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputData(reader->GetOutput());
    surface->Update();
    return surface->GetOutput();
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  read_with(reader.Get(), file);
  return reader->GetOutput();
}

// Polygons in the order of VTK's cells, and the number of each one's cell.
class Polygons {
 public:
  Polygons(vtkPolyData& surface, const std::string& file) : surface_(surface), file_(file) {}

  FacetMesh read() {
    for (vtkIdType k = 0; k < surface_.GetNumberOfPoints(); ++k) add_point(k);
    vtkIdType cell = surface_.GetNumberOfVerts() + surface_.GetNumberOfLines();
    each_cell(*surface_.GetPolys(), [&](const std::vector<std::uint32_t>& corners) { add(corners, cell++); });
    each_cell(*surface_.GetStrips(), [&](const std::vector<std::uint32_t>& corners) {
      for (std::size_t k = 2; k < corners.size(); ++k)
        add(k % 2 == 0 ? std::vector{corners[k - 2], corners[k - 1], corners[k]}
                       : std::vector{corners[k - 1], corners[k - 2], corners[k]},
            cell);
      ++cell;
    });
    return builder_.finish();
  }
  [[nodiscard]] const std::vector<vtkIdType>& cells() const { return cells_; }

 private:
  void add_point(vtkIdType k) {
    std::array<double, 3> p{};
    surface_.GetPoint(k, p.data());
    for (const double x : p)
      if (!is_coordinate(x))
        throw InputError(Place{file_},
                         fmt::format("point {}: expected finite coordinates, found ({}, {}, {})", k, p[0], p[1], p[2]));
    builder_.add_position({p[0], p[1], p[2]});
  }

  template <class Use>
  void each_cell(vtkCellArray& cells, const Use& use) {
    const auto iterator = vtk::TakeSmartPointer(cells.NewIterator());
    std::vector<std::uint32_t> corners;
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      iterator->GetCurrentCell(count, points);
      corners.clear();
      for (vtkIdType k = 0; k < count; ++k) {
        if (points[k] < 0 || points[k] >= surface_.GetNumberOfPoints())
          throw InputError(Place{file_}, fmt::format("point {} does not exist, the file has {}", points[k],
                                                     surface_.GetNumberOfPoints()));
        corners.push_back(static_cast<std::uint32_t>(points[k]));
      }
      use(corners);
    }
  }

  void add(const std::vector<std::uint32_t>& corners, vtkIdType cell) {
    if (corners.size() < 3) return;
    builder_.add_polygon(corners);
    cells_.push_back(cell);
  }

  vtkPolyData& surface_;
  const std::string& file_;
  MeshBuilder builder_;
  std::vector<vtkIdType> cells_;  // of each polygon
};

bool is_integer(const vtkAbstractArray& array) {
  return array.IsNumeric() && array.GetDataType() != VTK_FLOAT && array.GetDataType() != VTK_DOUBLE;
}

std::optional<FacetNames> values_of(vtkAbstractArray& array, const FacetMesh& mesh,
                                    const std::vector<vtkIdType>& cells) {
  if (array.GetNumberOfComponents() != 1) return std::nullopt;
  if (!is_integer(array) && vtkStringArray::SafeDownCast(&array) == nullptr) return std::nullopt;
  PolygonWords words;
  for (std::size_t polygon = 0; polygon < cells.size(); ++polygon)
    if (cells[polygon] < array.GetNumberOfValues())
      words.set(polygon, std::string(array.GetVariantValue(cells[polygon]).ToString()));
  return words.of_facets(mesh);
}

// One a point; none: the file has none.
FileNormals normals_of(vtkPolyData& surface) {
  vtkPointData& points = *surface.GetPointData();
  vtkDataArray* array = points.GetNormals() != nullptr ? points.GetNormals() : points.GetArray("Normals");
  FileNormals normals;
  if (array == nullptr || array->GetNumberOfComponents() != 3 ||
      array->GetNumberOfTuples() != surface.GetNumberOfPoints())
    return normals;
  for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k) {
    std::array<double, 3> n{};
    array->GetTuple(k, n.data());
    normals.add({n[0], n[1], n[2]});
  }
  return normals;
}

// Our own facet files: an index into words.
void name_parts(vtkPolyData& surface, FacetMesh& mesh, const std::vector<vtkIdType>& cells) {
  auto* names = vtkStringArray::SafeDownCast(surface.GetFieldData()->GetAbstractArray("part_names"));
  vtkDataArray* index = surface.GetCellData()->GetArray("part");
  if (names == nullptr || index == nullptr || index->GetNumberOfComponents() != 1) return;
  FacetNames parts;
  for (vtkIdType k = 0; k < names->GetNumberOfValues(); ++k) parts.names.push_back(names->GetValue(k));
  for (const std::uint32_t polygon : mesh.source_facet) {
    const double part = cells[polygon] < index->GetNumberOfTuples() ? index->GetTuple1(cells[polygon]) : -1.0;
    if (!(part >= 0.0 && part < static_cast<double>(parts.names.size()))) return;
    parts.of.push_back(static_cast<std::uint32_t>(part));
  }
  mesh.part = std::move(parts);
}

}  // namespace

ImportedMesh read_vtk(const std::filesystem::path& file, const std::string& unit, const Curving& curving) {
  const std::string name = file.string();
  const vtkSmartPointer<vtkPolyData> surface = surface_of(name);
  ImportedMesh imported;
  Polygons polygons(*surface, name);
  imported.mesh = polygons.read();
  if (imported.mesh.size() == 0) throw InputError(Place{name}, "holds no facets, expected at least one");
  vtkCellData& arrays = *surface->GetCellData();
  for (int k = 0; k < arrays.GetNumberOfArrays(); ++k) {
    vtkAbstractArray* array = arrays.GetAbstractArray(k);
    if (array == nullptr || array->GetName() == nullptr) continue;
    if (auto values = values_of(*array, imported.mesh, polygons.cells()))
      imported.mesh.properties.push_back({array->GetName(), std::move(*values)});
  }
  name_parts(*surface, imported.mesh, polygons.cells());
  if (curving.by == Curving::By::file_normals) normals_of(*surface).curve(imported.mesh, name, imported.warnings);
  imported.unit = unit;
  if (!unit.empty()) imported.mesh.metres_per_unit = metres_in(unit);
  return imported;
}

}  // namespace lrcs
