#include "cad/read_nodes.h"

#include <assimp/scene.h>
#include <fmt/format.h>
#include <zip.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/digest.h"
#include "base/input_error.h"
#include "base/length.h"
#include "cad/part_names.h"
#include "mesh/file_normals.h"
#include "mesh/mesh_builder.h"

namespace lrcs {
namespace {

using Place3 = Eigen::Matrix<double, 3, 4>;

Place3 place_of(const aiMatrix4x4& m) {
  Place3 place;
  place << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4;
  return place;
}

Place3 placed(const Place3& outer, const Place3& inner) {
  Place3 both;
  both.leftCols<3>() = outer.leftCols<3>() * inner.leftCols<3>();
  both.col(3) = outer.leftCols<3>() * inner.col(3) + outer.col(3);
  return both;
}

// What a place does to normals, but for their length: they stay across their surface, and on the side they point to.
Eigen::Matrix3d placing_normals(const Place3& place) {
  const Vec3 x = place.col(0), y = place.col(1), z = place.col(2);
  Eigen::Matrix3d cofactors;
  cofactors << y.cross(z), z.cross(x), x.cross(y);
  return x.dot(y.cross(z)) < 0.0 ? Eigen::Matrix3d(-cofactors) : cofactors;
}

// On one line.
std::string text_of(const aiString& name) {
  std::string text(name.C_Str());
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

// assimp calls nodes without a name "nodes[3]", and the parts of a mesh "name-0", "name-1".
std::string name_of(const aiScene& scene, const aiNode& node) {
  std::string name = text_of(node.mName);
  if (!name.starts_with("nodes[")) return name;
  if (node.mNumMeshes == 0) return "";
  name = text_of(scene.mMeshes[node.mMeshes[0]]->mName);
  if (node.mNumMeshes > 1 && name.ends_with("-0")) name.resize(name.size() - 2);
  return name;
}

double srgb_of(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

std::string colour_of(const aiMaterial& material, FileFormat format) {
  aiColor4D colour;
  if (material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != aiReturn_SUCCESS) return "";
  std::string text = "#";
  for (const float part : {colour.r, colour.g, colour.b}) {
    const double value = format == FileFormat::gltf ? srgb_of(static_cast<double>(part)) : static_cast<double>(part);
    if (!std::isfinite(value)) return "";
    text += fmt::format("{:02x}", std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  }
  return text;
}

// assimp gives what has no material one, and puts the number of a 3MF resource before names: "id5_Gold".
std::string material_name(const aiMaterial& material, FileFormat format) {
  aiString word;
  material.Get(AI_MATKEY_NAME, word);
  std::string name = text_of(word);
  if (name == AI_DEFAULT_MATERIAL_NAME) return "";
  const std::size_t number_end = name.find_first_not_of("0123456789", 2);
  if (format == FileFormat::three_mf && name.starts_with("id") && number_end != std::string::npos &&
      name[number_end] == '_')
    name.erase(0, number_end + 1);
  return name;
}

class Walk {
 public:
  // normals: get those of all vertices; null: not wanted.
  Walk(const aiScene& scene, FileFormat format, std::string file, FileNormals* normals)
      : scene_(scene), format_(format), file_(std::move(file)), normals_(normals) {}

  FacetMesh run() {
    find_instances();
    std::vector<std::string> paths;
    for (const Waiting& instance : instances_) paths.push_back(instance.path);
    paths = numbered(std::move(paths), "");
    for (std::size_t j = 0; j < instances_.size(); ++j)
      for (unsigned k = 0; k < instances_[j].node->mNumMeshes; ++k)
        add(*scene_.mMeshes[instances_[j].node->mMeshes[k]], instances_[j].place, paths[j]);
    return builder_.finish();
  }

 private:
  struct Waiting {
    const aiNode* node;
    Place3 place;  // of what holds it; of itself once it is an instance
    std::string path;
  };

  // All nodes with meshes.
  void find_instances() {
    waiting_.push_back({scene_.mRootNode, place_of(aiMatrix4x4()), root_name()});
    // Files may nest nodes as deep as they like.
    while (!waiting_.empty()) {
      Waiting next = waiting_.back();
      waiting_.pop_back();
      next.place = placed(next.place, place_of(next.node->mTransformation));
      push_children(*next.node, next.place, next.path);
      if (next.node->mNumMeshes > 0) instances_.push_back(std::move(next));
    }
  }

  // A root that only holds the others says nothing.
  [[nodiscard]] std::string root_name() const {
    const aiNode& root = *scene_.mRootNode;
    const std::string name = name_of(scene_, root);
    return root.mNumMeshes == 0 && (name == "ROOT" || name == "3MF" || name.empty()) ? "" : name;
  }

  void push_children(const aiNode& node, const Place3& here, const std::string& path) {
    std::vector<std::string> names;
    for (unsigned k = 0; k < node.mNumChildren; ++k) {
      const aiNode& child = *node.mChildren[k];
      std::string name = name_of(scene_, child);
      // One without a name and meshes is no level of the tree.
      names.push_back(name.empty() && child.mNumMeshes > 0 ? "part" : std::move(name));
    }
    names = numbered(std::move(names), "");
    for (unsigned k = node.mNumChildren; k-- > 0;) {
      const bool named = !names[k].empty() && names[k].front() != ':';
      waiting_.push_back({node.mChildren[k], here, !named ? path : path.empty() ? names[k] : path + "/" + names[k]});
    }
  }

  void add(const aiMesh& mesh, const Place3& here, const std::string& path) {
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    const std::string name = material_name(material, format_);
    builder_.begin_part(path);
    builder_.begin_material(name);
    builder_.begin_colour(name.empty() ? "" : colour_of(material, format_));
    const auto first = static_cast<std::uint32_t>(builder_.position_count());
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) builder_.add_position(position(mesh.mVertices[k], here));
    if (normals_ != nullptr) add_normals(mesh, here);
    const bool turn = here.leftCols<3>().determinant() < 0.0;
    for (unsigned k = 0; k < mesh.mNumFaces; ++k) {
      const aiFace& face = mesh.mFaces[k];
      if (face.mNumIndices < 3) continue;
      corners_.clear();
      for (unsigned j = 0; j < face.mNumIndices; ++j) {
        if (face.mIndices[j] >= mesh.mNumVertices)
          throw InputError(Place{file_}, fmt::format("mesh '{}': vertex {} does not exist, it has {}",
                                                     text_of(mesh.mName), face.mIndices[j], mesh.mNumVertices));
        corners_.push_back(first + face.mIndices[j]);
      }
      if (turn) std::reverse(corners_.begin(), corners_.end());
      builder_.add_polygon(corners_);
    }
  }

  void add_normals(const aiMesh& mesh, const Place3& here) {
    constexpr unsigned no_faces = aiPrimitiveType_POINT | aiPrimitiveType_LINE;
    if (!mesh.HasNormals() && (mesh.mPrimitiveTypes & ~no_faces) != 0)
      throw InputError(Place{file_}, fmt::format("mesh '{}' has no normals at its vertices, expected them for curved: "
                                                 "file_normals",
                                                 text_of(mesh.mName)));
    const Eigen::Matrix3d placing = placing_normals(here);
    for (unsigned k = 0; k < mesh.mNumVertices; ++k)
      normals_->add(mesh.HasNormals() ? Vec3(placing * Vec3(mesh.mNormals[k].x, mesh.mNormals[k].y, mesh.mNormals[k].z))
                                      : Vec3(Vec3::Zero()));
  }

  [[nodiscard]] Vec3 position(const aiVector3D& v, const Place3& here) const {
    Vec3 p = here.leftCols<3>() * Vec3(v.x, v.y, v.z) + here.col(3);
    for (const double x : p)
      if (!is_coordinate(x))
        throw InputError(Place{file_},
                         fmt::format("expected finite coordinates, found ({}, {}, {})", p.x(), p.y(), p.z()));
    return p;
  }

  const aiScene& scene_;
  FileFormat format_;
  std::string file_;
  FileNormals* normals_;
  std::vector<Waiting> waiting_, instances_;
  MeshBuilder builder_;
  std::vector<std::uint32_t> corners_;
};

// What assimp complains of without giving up: the user's to know.
class Complaints : public Assimp::LogStream {
 public:
  explicit Complaints(std::vector<std::string>& warnings) : warnings_(warnings) {}
  void write(const char* message) override {
    constexpr std::size_t most = 20;
    std::string text(message);
    text.erase(std::find(text.begin(), text.end(), '\n'), text.end());
    // "Warn,  T0: ..."
    if (const std::size_t prefix = text.find(": "); prefix < 12) text.erase(0, prefix + 2);
    if (text.starts_with("Ignored file of un")) return;  // of a ZIP archive, the model itself among them
    if (warnings_.size() < most && std::find(warnings_.begin(), warnings_.end(), text) == warnings_.end())
      warnings_.push_back(text);
  }

 private:
  std::vector<std::string>& warnings_;
};

// assimp's log goes to `warnings` as long as this lives; it owns the stream.
class Log {
 public:
  explicit Log(std::vector<std::string>& warnings) {
    Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
    Assimp::DefaultLogger::get()->attachStream(new Complaints(warnings), Assimp::Logger::Warn | Assimp::Logger::Err);
  }
  ~Log() { Assimp::DefaultLogger::kill(); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
};

// The JSON of a glTF file, or of the first chunk of a binary one.
nlohmann::json json_of(const std::filesystem::path& file) {
  const std::string content = content_of_file(file);
  std::string_view text = content;
  if (text.starts_with("glTF")) {
    constexpr std::size_t head = 20;  // of the file and of its first chunk
    if (text.size() < head) throw InputError(Place{file.string()}, "ends within its header, expected glTF");
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof length);
    text = text.substr(head, length);
  }
  auto json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  if (!json.is_object()) throw InputError(Place{file.string()}, "holds no JSON object that can be read, expected glTF");
  return json;
}

// What assimp would read as if it were not there.
void require_plain_gltf(const std::filesystem::path& file, bool normals_wanted, std::vector<std::string>& warnings) {
  const auto json = json_of(file);
  const auto list = [](const nlohmann::json& holder, const char* key) {
    const auto found = holder.find(key);
    return found != holder.end() && found->is_array() ? *found : nlohmann::json::array();
  };
  for (const auto& extension : list(json, "extensionsRequired")) {
    const std::string name = extension.is_string() ? extension.get<std::string>() : "?";
    if (name.starts_with("KHR_materials") || name.starts_with("KHR_texture") || name.starts_with("EXT_texture") ||
        name == "KHR_lights_punctual")
      continue;
    throw InputError(Place{file.string()}, fmt::format("requires the extension {}, expected glTF without it", name));
  }
  for (const auto& extension : list(json, "extensionsUsed"))
    if (extension == "EXT_mesh_gpu_instancing")
      warnings.emplace_back("EXT_mesh_gpu_instancing is not read: of its instances one is there");
  const auto accessors = list(json, "accessors");
  for (const auto& mesh : list(json, "meshes"))
    for (const auto& primitive : list(mesh, "primitives")) {
      if (primitive.contains("targets") && warnings.empty())
        warnings.emplace_back("morph targets are not applied: meshes are as they were modelled");
      const auto require_floats = [&](const nlohmann::json::json_pointer& attribute, const char* what) {
        const auto index = primitive.value(attribute, nlohmann::json());
        if (!index.is_number_unsigned() || index.get<std::size_t>() >= accessors.size()) return;
        constexpr int floats = 5126;
        if (accessors[index.get<std::size_t>()].value("componentType", floats) != floats)
          throw InputError(Place{file.string()},
                           fmt::format("has {} that are not floats, expected glTF without quantization", what));
      };
      require_floats("/attributes/POSITION"_json_pointer, "positions");
      if (normals_wanted) require_floats("/attributes/NORMAL"_json_pointer, "normals");
    }
}

// Does any triangle say a material or a colour? head: what of the model is read already.
bool has_triangle_properties(zip_file_t& model, const std::string& head) {
  constexpr std::string_view words = " p1=\"";
  std::string window = head;
  std::string next(1 << 20U, '\0');
  for (;;) {
    if (window.find(words) != std::string::npos) return true;
    const zip_int64_t count = zip_fread(&model, next.data(), next.size());
    if (count <= 0) return false;
    window.erase(0, window.size() - std::min(window.size(), words.size() - 1));
    window.append(next.data(), static_cast<std::size_t>(count));
  }
}

// The unit that a 3MF file says in its model: assimp passes it over. The default of the format: millimetres.
std::string unit_of_3mf(const std::string& file, std::vector<std::string>& warnings) {
  struct Name {
    const char *word, *unit;
  };
  constexpr std::array names{Name{"micron", "um"}, Name{"millimeter", "mm"}, Name{"centimeter", "cm"},
                             Name{"inch", "inch"}, Name{"foot", "ft"},       Name{"meter", "m"}};
  const std::unique_ptr<zip_t, decltype(&zip_discard)> archive(zip_open(file.c_str(), ZIP_RDONLY, nullptr),
                                                               &zip_discard);
  if (!archive) throw InputError(Place{file}, "is no ZIP archive that can be read, expected 3MF");
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> model(
      zip_fopen(archive.get(), "3D/3dmodel.model", ZIP_FL_NOCASE), &zip_fclose);
  if (!model) throw InputError(Place{file}, "holds no 3D/3dmodel.model, expected 3MF");
  std::string head(65536, '\0');
  head.resize(static_cast<std::size_t>(std::max<zip_int64_t>(0, zip_fread(model.get(), head.data(), head.size()))));
  if (has_triangle_properties(*model, head))
    warnings.emplace_back("materials and colours of single triangles are not read: a facet has its object's");
  const std::size_t begin = head.find("<model");
  const std::string tag = begin == std::string::npos ? "" : head.substr(begin, head.find('>', begin) - begin);
  const std::size_t unit = tag.find(" unit=\"");
  if (unit == std::string::npos) return "mm";
  const std::string word = tag.substr(unit + 7, tag.find('"', unit + 7) - unit - 7);
  for (const Name& name : names)
    if (word == name.word) return name.unit;
  throw InputError(Place{file}, fmt::format("expected a unit of 3MF (micron, millimeter, centimeter, inch, foot, "
                                            "meter), found '{}'",
                                            word));
}

}  // namespace

ImportedMesh read_nodes(const std::filesystem::path& file, FileFormat format, const std::string& unit,
                        const Curving& curving) {
  ImportedMesh imported;
  const bool by_normals = curving.by == Curving::By::file_normals;
  std::string said = "m";
  if (format == FileFormat::gltf)
    require_plain_gltf(file, by_normals, imported.warnings);
  else
    said = unit_of_3mf(file.string(), imported.warnings);
  const Log log(imported.warnings);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw InputError(Place{file.string()}, fmt::format("cannot be read: {}", importer.GetErrorString()));
  FileNormals normals;
  imported.mesh = Walk(*scene, format, file.string(), by_normals ? &normals : nullptr).run();
  if (imported.mesh.size() == 0) throw InputError(Place{file.string()}, "holds no facets, expected at least one");
  if (by_normals) normals.curve(imported.mesh, file.string(), imported.warnings);
  imported.unit = unit.empty() ? said : unit;
  imported.mesh.metres_per_unit = metres_in(imported.unit);
  if (scene->mNumAnimations > 0) imported.warnings.push_back("animations are not applied");
  if (std::any_of(scene->mMeshes, scene->mMeshes + scene->mNumMeshes, [](const aiMesh* m) { return m->mNumBones > 0; }))
    imported.warnings.push_back("skins are not applied: their meshes are as they were modelled");
  return imported;
}

}  // namespace lrcs
