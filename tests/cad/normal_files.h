#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "tests/cad/made_gltf.h"
#include "tests/mesh/normal_files.h"

namespace lrcs {

// A .vtp file; attribute: that says which point data are the normals, or "".
inline std::string vtp(const VertexMesh& made, const std::string& attribute = R"( Normals="Normals")",
                       const std::string& array = "Normals") {
  std::string points, normals, corners, ends;
  for (std::size_t k = 0; k < made.normals.size(); ++k) {
    const Vec3 &p = made.mesh.positions[k], &n = made.normals[k];
    points += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
    normals += fmt::format("{} {} {}\n", n.x(), n.y(), n.z());
  }
  for (std::size_t k = 0; k < made.mesh.size(); ++k) {
    corners += fmt::format("{}\n", fmt::join(made.mesh.facets[k], " "));
    ends += fmt::format("{} ", 3 * (k + 1));
  }
  return fmt::format(R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>
<Piece NumberOfPoints="{}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{}">
<PointData{}><DataArray type="Float64" Name="{}" NumberOfComponents="3" format="ascii">
{}</DataArray></PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
{}</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">
{}</DataArray><DataArray type="Int64" Name="offsets" format="ascii">{}</DataArray></Polys>
</Piece></PolyData></VTKFile>
)",
                     made.mesh.positions.size(), made.mesh.size(), attribute, array, normals, points, corners, ends);
}

// The same as .vtu, of triangle cells.
inline std::string vtu(const VertexMesh& made) {
  std::string text = vtp(made);
  const auto replace = [&](const std::string& word, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
      text.replace(at, word.size(), by);
  };
  replace("PolyData", "UnstructuredGrid");
  replace("NumberOfPolys", "NumberOfCells");
  replace(R"( NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0")", "");
  std::string types;
  for (std::size_t k = 0; k < made.mesh.size(); ++k) types += "5 ";
  replace("</Polys>", R"(<DataArray type="UInt8" Name="types" format="ascii">)" + types + "</DataArray></Polys>");
  replace("Polys>", "Cells>");
  return text;
}

// glTF with one mesh, "body"; `nodes` is the content of the list of nodes, the first of which is the root.
inline std::string gltf(const VertexMesh& made, const std::string& nodes = R"({"mesh": 0})") {
  std::string data;
  Vec3 low = made.mesh.positions[0], high = low;
  for (const Vec3& p : made.mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const auto* list : {&made.mesh.positions, &made.normals})
    for (const Vec3& v : *list)
      for (const double x : v) data += bytes_of(static_cast<float>(x));
  const std::size_t each = data.size() / 2;
  for (const auto& facet : made.mesh.facets)
    for (const std::uint32_t corner : facet) data += bytes_of(corner);
  const std::size_t vertices = made.normals.size(), indices = 3 * made.mesh.size();
  return fmt::format(
      R"({{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}], "nodes": [{}],
"meshes": [{{"name": "body", "primitives": [{{"attributes": {{"POSITION": 0, "NORMAL": 1}}, "indices": 2}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": {}, "type": "VEC3", "min": [{}, {}, {}], "max": [{}, {}, {}]}},
 {{"bufferView": 1, "componentType": 5126, "count": {}, "type": "VEC3"}},
 {{"bufferView": 2, "componentType": 5125, "count": {}, "type": "SCALAR"}}],
"bufferViews": [{{"buffer": 0, "byteOffset": 0, "byteLength": {}}}, {{"buffer": 0, "byteOffset": {}, "byteLength": {}}},
 {{"buffer": 0, "byteOffset": {}, "byteLength": {}}}],
"buffers": [{{"byteLength": {}, "uri": "data:application/octet-stream;base64,{}"}}]}})",
      nodes, vertices, low.x(), low.y(), low.z(), high.x(), high.y(), high.z(), vertices, indices, each, each, each,
      2 * each, data.size() - 2 * each, data.size(), base64(data));
}

}  // namespace lrcs
